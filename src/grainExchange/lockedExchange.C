/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

Foam::grainMotion::twist Foam::grainFluidExchange::freeMotion
(
    const label graini
) const
{
    const grainMotion& motion = grains_.motion();
    const scalar deltaT = mesh_.time().deltaTValue();

    const grainMotion::twist now(motion.motion(graini));
    const grainMotion::twist change(motion.contactChange(graini, deltaT));
    return
    {
        now.velocity + change.velocity
      + deltaT*motion.reducedGravity(graini, rho_.value()),
        now.spin + change.spin
    };
}


void Foam::grainFluidExchange::setFluidShare()
{
    if (!resolved_.isActive())
    {
        fluidShare_ == eps_;
        return;
    }

    const overlapList& overlaps = grains_.overlaps();
    fluidShare_ == 1 - resolved_.locked();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for
        (
            label k = overlaps.start[graini];
            !resolved_.isResolved(graini) && k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            fluidShare_[celli] -= overlaps.volume[k]/mesh_.V()[celli];
        }
    }
    fluidShare_.max(0);
    fluidShare_.correctBoundaryConditions();
}


void Foam::grainFluidExchange::addLocked()
{
    const scalar deltaT = mesh_.time().deltaTValue();

    for (label celli = 0; resolved_.isActive() && celli < eps_.size(); ++celli)
    {
        const label graini = resolved_.grain(celli);
        if (graini < 0)
        {
            continue;
        }
        const scalar inertia = resolved_.density(graini)/deltaT;

        kappa_[celli] += 1;
        beta_[celli] += inertia;
        b_[celli] += inertia*freeMotion(graini).at(resolved_.arm(celli));
    }
}


void Foam::grainFluidExchange::addLockedForce
(
    const volVectorField& U,
    vectorField& force
) const
{
    const scalar deltaT = mesh_.time().deltaTValue();

    for (label celli = 0; resolved_.isActive() && celli < eps_.size(); ++celli)
    {
        const label graini = resolved_.grain(celli);
        if (graini < 0)
        {
            continue;
        }
        force[graini] +=
            mesh_.V()[celli]*resolved_.density(graini)/deltaT
           *(U[celli] - freeMotion(graini).at(resolved_.arm(celli)));
    }
}


Foam::tmp<Foam::volVectorField> Foam::grainFluidExchange::lockedU() const
{
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("lockedU", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(dimVelocity, Zero)
        )
    );
    volVectorField& result = tresult.ref();
    for (label celli = 0; resolved_.isActive() && celli < eps_.size(); ++celli)
    {
        const label graini = resolved_.grain(celli);
        if (graini >= 0)
        {
            result[celli] = freeMotion(graini).at(resolved_.arm(celli));
        }
    }
    result.correctBoundaryConditions();
    return tresult;
}
