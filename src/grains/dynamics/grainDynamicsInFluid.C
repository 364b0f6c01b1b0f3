/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "mathematicalConstants.H"
#include "nscd/shape/Members.hpp"
#include "planarCells.H"
#include "spatialCells.H"

template<int D>
void Foam::grainDynamics<D>::meshChanged()
{
    properties_.meshChanged();
    outlets_.meshChanged();
    isLocated_ = false;
    cell_.clear();
}


template<int D>
Foam::autoPtr<Foam::grainCells> Foam::grainDynamics<D>::cells() const
{
    if constexpr (D == 2)
    {
        return autoPtr<grainCells>(new planarCells(space()));
    }
    else
    {
        return autoPtr<grainCells>(new spatialCells(mesh()));
    }
}


template<int D>
Foam::grainBodies Foam::grainDynamics<D>::bodies() const
{
    const nscd::Grains<D>& g = grains();

    // Of the lengths that the fluid sees
    const scalar ratio = space().lengthRatio(properties_.packingRatio());

    grainBodies result;
    result.centre.resize(size());
    result.radius.resize(size());
    result.start.resize(size() + 1);
    result.start[0] = 0;

    if (g.clusters.empty())
    {
        result.member.resize(size());
        forAll(result.member, i)
        {
            result.centre[i] = space().positionInSpace(g.position[i]);
            result.radius[i] = ratio*radius(i);
            result.start[i + 1] = i + 1;
            result.member[i] = {result.centre[i], result.radius[i]};
        }
        return result;
    }

    const nscd::Members<D> members(g);
    const nscd::Vectors<D> centres(members.positions(g.position, g.orientation));
    result.member.resize(members.size());
    forAll(result.centre, i)
    {
        const point x(space().positionInSpace(g.position[i]));
        result.centre[i] = x;
        result.radius[i] = ratio*radius(i);
        if (g.shape[i] >= 0)
        {
            result.radius[i] *= space().lengthRatio
            (
                space().volume(g, i)/space().volume(radius(i))
            );
        }

        result.start[i + 1] = members.first(i + 1);
        for (label m = result.start[i]; m < result.start[i + 1]; ++m)
        {
            const vector arm(space().positionInSpace(centres[m]) - x);
            result.member[m] = {x + ratio*arm, ratio*members.radius()[m]};
        }
    }
    return result;
}


template<int D>
Foam::grainMotion::twist Foam::grainDynamics<D>::changeBy
(
    const nscd::Wrenches<D>& given,
    const label graini,
    const scalar time
) const
{
    const nscd::Spin<D> spin
    (
        nscd::spinOf<D>
        (
            grains(), graini, grains().orientation[graini], given.torque[graini]
        )
    );
    return
    {
        time*space().toSpace(given.force[graini])/grains().mass[graini],
        time*space().spinInSpace(spin)
    };
}


template<int D>
Foam::grainMotion::twist Foam::grainDynamics<D>::contactChange
(
    const label graini,
    const scalar deltaT
) const
{
    if (isFixed())
    {
        return {Zero, Zero};
    }
    const grainMotion::twist lasting(changeBy(dynamics().lasting(), graini, deltaT));
    const grainMotion::twist owed(changeBy(dynamics().owed(), graini, 1));
    return {lasting.velocity + owed.velocity, lasting.spin + owed.spin};
}


template<int D>
Foam::grainMotion::twist Foam::grainDynamics<D>::unexpectedChange
(
    const label graini
) const
{
    if (isFixed())
    {
        return {Zero, Zero};
    }
    const grainMotion::twist all(changeBy(dynamics().unexpected(), graini, 1));
    const grainMotion::twist owed(changeBy(dynamics().owed(), graini, 1));
    return {all.velocity - owed.velocity, all.spin - owed.spin};
}


template<int D>
Foam::tensor Foam::grainDynamics<D>::momentOfInertia(const label graini) const
{
    const auto column = [&](const label axis)
    {
        nscd::Spin<D> spin(nscd::Spin<D>::Zero());
        spin[axis] = 1;
        return nscd::angularMomentum<D>(grains(), graini, spin);
    };
    if (D == 2)
    {
        return column(0)[0]*tensor::I;
    }
    tensor result(Zero);
    for (label j = 0; j < D; ++j)
    {
        const nscd::Spin<D> momentum(column(j));
        for (label i = 0; i < D; ++i)
        {
            result[3*i + j] = momentum[i];
        }
    }
    return result;
}


template<int D>
void Foam::grainDynamics<D>::lubricate
(
    const std::function<scalar(scalar, scalar)>& restitution,
    const scalarField& viscosity
)
{
    if (isFixed())
    {
        return;
    }
    std::vector<double> ofMass(viscosity.begin(), viscosity.end());
    if constexpr (D == 2)
    {
        // A disc has the film of a sphere, and the mass of a rod as long as the
        // mesh is deep
        for (label i = 0; i < size(); ++i)
        {
            ofMass[i] *=
                0.75*grains().mass[i]
               /(constant::mathematical::pi*density(i)*pow3(radius(i)));
        }
    }
    dynamics_->setLubrication(restitution, std::move(ofMass));
}


template<int D>
void Foam::grainDynamics<D>::entrain(const scalarField& ratio)
{
    if (!isFixed())
    {
        const scalarField heaviness(1 + ratio);
        dynamics_->setHeaviness
        (
            std::vector<double>(heaviness.begin(), heaviness.end())
        );
    }
}


template<int D>
void Foam::grainDynamics<D>::move
(
    const vectorField& fluidForce,
    const vectorField& fluidTorque,
    const scalar deltaT
)
{
    if (isFixed())
    {
        underForces
        (
            vectorField(), vectorField(), deltaT,
            [&](const nscd::Vectors<D>&, const nscd::Spins<D>&)
            {
                dynamics_->carryWalls(deltaT);
            }
        );
    }
    else
    {
        advance(fluidForce, fluidTorque, deltaT);
    }
    if (mesh().moving())
    {
        properties_.patches().check(dynamics().wallBodies());
    }
    fluidForce_ = fluidForce;
}


template<int D>
void Foam::grainDynamics<D>::resize
(
    const scalarField& radius,
    const scalarField& mass
)
{
    dynamics_->resize
    (
        std::vector<double>(radius.begin(), radius.end()),
        std::vector<double>(mass.begin(), mass.end())
    );
    isResized_ = true;
}


template void Foam::grainDynamics<2>::meshChanged();
template void Foam::grainDynamics<3>::meshChanged();
template Foam::autoPtr<Foam::grainCells> Foam::grainDynamics<2>::cells() const;
template Foam::autoPtr<Foam::grainCells> Foam::grainDynamics<3>::cells() const;
template Foam::grainBodies Foam::grainDynamics<2>::bodies() const;
template Foam::grainBodies Foam::grainDynamics<3>::bodies() const;
template Foam::grainMotion::twist Foam::grainDynamics<2>::contactChange
(
    const label, const scalar
) const;
template Foam::grainMotion::twist Foam::grainDynamics<3>::contactChange
(
    const label, const scalar
) const;
template Foam::tensor Foam::grainDynamics<2>::momentOfInertia
(
    const label
) const;
template Foam::tensor Foam::grainDynamics<3>::momentOfInertia
(
    const label
) const;
template void Foam::grainDynamics<2>::resize
(
    const scalarField&, const scalarField&
);
template void Foam::grainDynamics<3>::resize
(
    const scalarField&, const scalarField&
);
template void Foam::grainDynamics<2>::lubricate
(
    const std::function<scalar(scalar, scalar)>&, const scalarField&
);
template void Foam::grainDynamics<3>::lubricate
(
    const std::function<scalar(scalar, scalar)>&, const scalarField&
);
template void Foam::grainDynamics<2>::entrain(const scalarField&);
template void Foam::grainDynamics<3>::entrain(const scalarField&);
template void Foam::grainDynamics<2>::move
(
    const vectorField&, const vectorField&, const scalar
);
template void Foam::grainDynamics<3>::move
(
    const vectorField&, const vectorField&, const scalar
);
