/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unresolvedTerm.H"

#include "fvcGrad.H"
#include "reconstruction.H"
#include "turning.H"

#include <optional>

namespace
{

using namespace Foam;

vector vorticity(const tensor& grad)
{
    return vector
    (
        grad.yz() - grad.zy(), grad.zx() - grad.xz(), grad.xy() - grad.yx()
    );
}


//- Velocity in the cells as seen from them
tmp<volVectorField> relativeToCells(const volVectorField& U)
{
    const fvMesh& mesh = U.mesh();
    return mesh.moving() ? U - reconstructed(mesh.phi()) : tmp<volVectorField>(U);
}


//- A disc or sphere that a law turns (doc/theory, eq. 2.40), implicit in its spin, which
//  contacts are expected to change
class turningGrain
{
    const label nDimensions_;
    const scalar deltaT_;
    const scalar density_;
    const scalar diameter_;

    //- Square of the radius of gyration of what the fluid sees [m^2]
    const scalar gyration_;

    //- Its moment of inertia over the grain's: packingRatio shows the fluid another radius
    const scalar seen_;

    const vector spin_;
    const vector byContacts_;

public:

    turningGrain
    (
        const grainSystem& grains,
        const label graini,
        const scalar deltaT
    )
    :
        nDimensions_(grains.mesh().nGeometricD()),
        deltaT_(deltaT),
        density_(grains.motion().density(graini)),
        diameter_(grains.lawDiameter(graini)),
        gyration_
        (
            sqr(grains.members(graini)[0].radius)/(nDimensions_ == 2 ? 2 : 2.5)
        ),
        seen_
        (
            grains.motion().mass(graini)*gyration_
           /grains.motion().momentOfInertia(graini).zz()
        ),
        spin_(grains.motion().motion(graini).spin),
        byContacts_(grains.motion().contactChange(graini, deltaT).spin)
    {}

    //- On the part of the grain in a cell [N m]
    vector torque
    (
        const scalar volume,
        const scalar rho,
        const scalar mu,
        const tensor& gradU
    ) const
    {
        const vector lack(0.5*vorticity(gradU) - spin_);
        const scalar rate = turning::rate
        (
            nDimensions_, diameter_, density_, rho, mu, mag(lack)
        );
        return
            density_*volume*gyration_*rate/(1 + seen_*rate*deltaT_)
           *(lack - byContacts_);
    }
};

}

void Foam::unresolvedTerm::setKnownForce(const volVectorField& U)
{
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = grains_.mesh().time().deltaTValue();

    knownForce_.resize(overlaps.size());
    knownForce_ = Zero;
    if (addedMass_ == 0 && lift_.empty())
    {
        return;
    }

    const volTensorField gradU(fvc::grad(U));
    const tmp<volVectorField> through(relativeToCells(U));

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const grainMotion::twist motion(grains_.motion().motion(graini));
        const scalar d = grains_.lawDiameter(graini);

        for (const cellOverlap& o : overlaps.of(graini))
        {
            vector& e = knownForce_[o.index];
            const tensor& grad = gradU[o.cell];
            const vector w(U[o.cell] + at_.velocity(o) - motion.at(o.arm));

            e = -dragOfAddedMass(fluid_.rho()[o.cell])*(w - deltaT*(through()[o.cell] & grad));

            for (const liftLaw& law : lift_)
            {
                e += law.force
                (
                    w, vorticity(grad), motion.spin, d,
                    fluid_.rho()[o.cell], fluid_.mu()[o.cell]
                );
            }
        }
    }
}


void Foam::unresolvedTerm::addForceAtStart
(
    const volVectorField& U,
    const resolvedTerm& resolved,
    vectorField& force,
    scalarField& massOfDrag
) const
{
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const tmp<scalarField> rho(weight_.seen());

    // Drag that holds a grain in a step so that it keeps a hundredth of any other
    // velocity; a mass of more would make much of the contact solver's error.
    // The added mass counts in full: the known force has its other part.
    constexpr scalar stiff = 100;

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (resolved.isResolved(graini))
        {
            continue;
        }
        const vector v(grains_.motion().velocity(graini));
        const scalar mostGamma = stiff*grains_.motion().density(graini)/deltaT;
        for (const cellOverlap& o : overlaps.of(graini))
        {
            const scalar added = dragOfAddedMass(fluid_.rho()[o.cell]);
            const scalar gamma =
                added + min(transfer_[o.index].gamma - added, mostGamma);
            const scalar inLiquid = resolved.inLiquid(o);
            const scalar volume = (1 - inLiquid)*o.volume;
            force[graini] +=
                weight_.force(o.volume, rho()[o.cell])
              + volume
               *(gamma*(U[o.cell] + at_.velocity(o) - v) + knownForce_[o.index]);
            massOfDrag[graini] += volume*gamma*deltaT;
            if (inLiquid > 0)
            {
                const scalar gammaInLiquid =
                    min(inLiquid_[o.index].gamma, mostGamma);
                force[graini] +=
                    inLiquid*o.volume*gammaInLiquid
                   *(resolved.liquidVelocity(o.cell) - v);
                massOfDrag[graini] += inLiquid*o.volume*gammaInLiquid*deltaT;
            }
        }
    }
}


void Foam::unresolvedTerm::addForce
(
    const volVectorField& U,
    const volVectorField& gradP,
    const resolvedTerm& resolved,
    vectorField& force,
    vectorField& torque
) const
{
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = grains_.mesh().time().deltaTValue();
    const vectorField& C = grains_.mesh().C();

    // For the torque, the fluid's velocity where the overlap is: a grain that
    // straddles two cells would take their difference for a spin
    const volTensorField gradU(fvc::grad(U));
    const tmp<scalarField> rho(weight_.seen());

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (resolved.isResolved(graini))
        {
            continue;
        }
        const scalar rhop = grains_.motion().density(graini);
        const bool isRound = grains_.members(graini).size() == 1;
        std::optional<turningGrain> turning;
        if (isRound)
        {
            turning.emplace(grains_, graini, deltaT);
        }

        for (const cellOverlap& o : overlaps.of(graini))
        {
            const scalar onGrains =
                gradientOnGrains_ && !resolved.isLiquid(o.cell);
            const implicitTransfer<vector>& t = transfer_[o.index];
            const vector accelerated
            (
                resolved.isLiquid(o.cell)
              ? vector
                (
                    t.a*fluid_.rho()[o.cell]/deltaT
                   *(U[o.cell] - resolved.liquidVelocity(o.cell))
                )
              : vector(Zero)
            );
            const scalar inLiquid = resolved.inLiquid(o);
            vector f
            (
                (1 - inLiquid)*o.volume
               *(
                  - onGrains*gradP[o.cell]
                  + t.given
                    (
                        U[o.cell], onGrains*deltaT/rhop*gradP[o.cell]
                    )
                  + knownForce_[o.index]
                  + accelerated
                )
            );
            if (inLiquid > 0)
            {
                f += inLiquid*o.volume*forceOfLiquid(graini, o, resolved);
            }
            const vector fromCentre
            (
                o.arm
              - grains_.shortest(C[o.cell] - grains_.centres()[graini])
            );
            const vector shear
            (
                o.volume*(t.gamma - dragOfAddedMass(fluid_.rho()[o.cell]))*t.a
               *((fromCentre & gradU[o.cell]) - at_.velocity(o))
            );
            force[graini] += weight_.force(o.volume, rho()[o.cell]);
            force[graini] += f;

            const scalar byLaw =
                isRound
              ? turning::shareOfLaw
                (
                    grains_.fluidDiameter(graini), undisturbed_.cellSize()[o.cell]
                )
              : 0;
            torque[graini] += (1 - byLaw)*(o.arm ^ (f + shear));
            if (byLaw > 0)
            {
                torque[graini] +=
                    byLaw
                   *turning->torque
                    (
                        o.volume, fluid_.rho()[o.cell], fluid_.mu()[o.cell],
                        gradU[o.cell]
                    );
            }
        }
    }
}
