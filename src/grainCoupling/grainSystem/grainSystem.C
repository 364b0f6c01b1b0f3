/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSystem.H"

#include "dictionaryInput.H"
#include "grainChecks.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "Pstream.H"

namespace Foam
{
    defineTypeNameAndDebug(grainSystem, 0);
    const word grainSystem::registryName("grainSystem");
}


Foam::grainSystem::grainSystem(const fvMesh& mesh, const vector& g)
:
    regIOobject
    (
        IOobject(registryName, mesh.time().timeName(), mesh)
    ),
    properties_(mesh, g),
    voidFraction_
    (
        voidFractionMethod::New
        (
            dictionaryInput::subDict(properties_.coupling(), "voidFraction"),
            plane()
        )
    )
{
    const bool restart = isFile(stateFile(), false);

    try
    {
        dynamics_.reset
        (
            new nscd::ContactDynamics<2>
            (
                restart ? nscd::Grains<2>() : properties_.initialGrains(),
                properties_.walls(),
                properties_.materials().contactTable(),
                properties_.contact()
            )
        );
        if (restart)
        {
            dynamics_->load(stateFile());
            Info<< "Grains continue from " << stateFile() << endl;
        }
        else if (mesh.time().value() > 0)
        {
            WarningInFunction
                << "There is no " << stateFile() << ": the initial grains of "
                << properties_.dict().name() << " are put into the fields of"
                << " time " << mesh.time().timeName() << endl;
        }
    }
    catch (const std::exception& err)
    {
        FatalIOErrorInFunction(properties_.dict())
            << "Keyword '" << (restart ? "startTime" : "initialGrains")
            << "': " << err.what() << exit(FatalIOError);
    }

    const grainChecks checks(properties_, dynamics_->grains());
    checks.requireMasses();
    checks.requireLaws();
    if (!restart)
    {
        checks.requireInside();
        checks.requireNoOverlap();
    }

    fluidForce_.resize(dynamics_->grains().size(), Zero);
    map();
    checkLost();
}


Foam::scalar Foam::grainSystem::volume(const label graini) const
{
    return
        constant::mathematical::pi*sqr(fluidRadius_[graini])*plane().depth();
}


void Foam::grainSystem::map()
{
    const nscd::Grains<2>& grains = dynamics_->grains();
    const label n = label(grains.size());

    centre_.resize(n);
    fluidRadius_.resize(n);
    forAll(centre_, i)
    {
        centre_[i] = plane().positionInSpace(grains.position[i]);
        fluidRadius_[i] = Foam::sqrt(properties_.packingRatio())*grains.radius[i];
    }

    voidFraction_->map(centre_, fluidRadius_, overlaps_);

    mappedVolume_.resize(n);
    forAll(mappedVolume_, i)
    {
        mappedVolume_[i] = 0;
        for (label k = overlaps_.start[i]; k < overlaps_.start[i + 1]; ++k)
        {
            mappedVolume_[i] += overlaps_.volume[k];
        }
    }
    Pstream::listCombineGather(mappedVolume_, plusEqOp<scalar>());
    Pstream::listCombineScatter(mappedVolume_);
}


Foam::vector Foam::grainSystem::velocity
(
    const label graini,
    const vector& arm
) const
{
    const nscd::Grains<2>& grains = dynamics_->grains();
    return
        plane().toSpace(grains.velocity[graini])
      + (plane().spinInSpace(grains.spin[graini][0]) ^ arm);
}


Foam::vector Foam::grainSystem::contactVelocity
(
    const label graini,
    const vector& arm,
    const scalar deltaT
) const
{
    const scalar lastDeltaT = dynamics_->lastTimeStep();
    if (lastDeltaT <= 0)
    {
        return Zero;
    }

    const nscd::Grains<2>& grains = dynamics_->grains();
    const scalar m = grains.mass[graini];
    const scalar I =
        nscd::inertiaFactor<2>*m*sqr(grains.radius[graini]);

    return deltaT/lastDeltaT*
    (
        plane().toSpace(dynamics_->contactImpulse()[graini])/m
      + (
            plane().spinInSpace(dynamics_->contactSpinImpulse()[graini][0])/I
          ^ arm
        )
    );
}


void Foam::grainSystem::move
(
    const vectorField& fluidForce,
    const vectorField& fluidTorque,
    const scalar deltaT
)
{
    const nscd::Grains<2>& grains = dynamics_->grains();
    nscd::Vectors<2> force(grains.size());
    nscd::Spins<2> torque(grains.size());

    forAll(fluidForce, i)
    {
        force[i] = plane().toPlane(fluidForce[i] + grains.mass[i]*properties_.g());
        torque[i][0] = plane().toSpin(fluidTorque[i]);
    }

    try
    {
        lastStep_ = dynamics_->step(force, torque, deltaT);
    }
    catch (const std::exception& err)
    {
        FatalErrorInFunction
            << "The contact solver stopped at time "
            << mesh().time().timeName() << ": " << err.what()
            << exit(FatalError);
    }

    fluidForce_ = fluidForce;
    map();
}


void Foam::grainSystem::checkLost() const
{
    forAll(mappedVolume_, i)
    {
        if (mappedVolume_[i] <= 0)
        {
            FatalErrorInFunction
                << "Grain " << label(dynamics_->grains().id[i]) << " at "
                << centre_[i] << " with velocity " << velocity(i, Zero)
                << " has left the mesh at time " << mesh().time().timeName()
                << nl << "    there is a gap in the walls, or the time step"
                << " is too large for the contact solver (worst overlap "
                << lastStep_.worstOverlap << " m)" << exit(FatalError);
        }
    }
}
