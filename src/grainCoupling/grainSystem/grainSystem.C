/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSystem.H"

#include "cyclicPolyPatch.H"
#include "dictionaryInput.H"
#include "Pstream.H"

Foam::grainSystem::grainSystem(const fvMesh& mesh, const vector& g)
:
    grainDynamics<2>(mesh, g),
    voidFraction_
    (
        voidFractionMethod::New
        (
            dictionaryInput::subDict(properties().coupling(), "voidFraction"),
            space()
        )
    )
{
    for (const int shapei : grains().shape)
    {
        if (shapei >= 0)
        {
            FatalIOErrorInFunction(properties().dict())
                << "Keyword 'shape' of 'initialGrains' names "
                << properties().shapes().name(shapei) << nl
                << "    allowed with a fluid: " << grainSpace<2>::shape
                << exit(FatalIOError);
        }
    }

    if (heat())
    {
        FatalIOErrorInFunction(properties().dict())
            << "Keyword 'heat': this solver does not conduct heat" << nl
            << "    allowed: in dryGrainFoam" << exit(FatalIOError);
    }

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            WarningInFunction
                << "Grains do not pass through the cyclic patch "
                << patch.name() << ": one that reaches it leaves the mesh"
                << endl;
        }
    }

    fluidForce_.resize(size(), Zero);
    map();
    checkLost();
}


Foam::scalar Foam::grainSystem::volume(const label graini) const
{
    return space().volume(fluidRadius_[graini]);
}


void Foam::grainSystem::map()
{
    const label n = size();

    centre_.resize(n);
    fluidRadius_.resize(n);
    forAll(centre_, i)
    {
        centre_[i] = centre(i);
        fluidRadius_[i] = Foam::sqrt(properties().packingRatio())*radius(i);
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


Foam::vector Foam::grainSystem::contactVelocity
(
    const label graini,
    const vector& arm,
    const scalar deltaT
) const
{
    const scalar lastDeltaT = dynamics().lastTimeStep();
    if (lastDeltaT <= 0)
    {
        return Zero;
    }

    const nscd::Spin<2> spin
    (
        nscd::spinOf<2>
        (
            grains(), graini, grains().orientation[graini],
            dynamics().contactSpinImpulse()[graini]
        )
    );
    return deltaT/lastDeltaT*
    (
        space().toSpace(dynamics().contactImpulse()[graini])
       /grains().mass[graini]
      + (space().spinInSpace(spin) ^ arm)
    );
}


void Foam::grainSystem::move
(
    const vectorField& fluidForce,
    const vectorField& fluidTorque,
    const scalar deltaT
)
{
    advance(fluidForce, fluidTorque, deltaT);
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
                << "Grain " << id(i) << " at "
                << centre_[i] << " with velocity " << velocity(i)
                << " has left the mesh at time " << mesh().time().timeName()
                << nl << "    there is a gap in the walls, or the time step"
                << " is too large for the contact solver (worst overlap "
                << lastStep().worstOverlap << " m)" << exit(FatalError);
        }
    }
}
