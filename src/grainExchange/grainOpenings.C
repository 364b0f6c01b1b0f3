/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

#include "combineOverRanks.H"
#include "fvcFlux.H"

void Foam::grainFluidExchange::setFreePatches(const volVectorField& U)
{
    freePatches_.clear();
    for (const label patchi : grains_.motion().openings())
    {
        if (U.boundaryField()[patchi].assignable())
        {
            freePatches_.insert(patchi);
        }
    }
}


template<class Type>
void Foam::grainFluidExchange::extrapolate
(
    GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    for (const label patchi : freePatches_)
    {
        fvPatchField<Type>& patch = field.boundaryFieldRef()[patchi];
        patch == patch.patchInternalField();
    }
}


void Foam::grainFluidExchange::extendForce
(
    vectorField& force,
    vectorField& torque
)
{
    const overlapList& overlaps = grains_.overlaps();

    // First moment of what is inside, about the centre
    vectorField moment(grains_.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for
        (
            label k = overlaps.start[graini];
            grains_.isAtOpening(graini) && k < overlaps.start[graini + 1];
            ++k
        )
        {
            moment[graini] += overlaps.volume[k]*overlaps.arm[k];
        }
    }
    if (grains_.motion().openings().size())
    {
        sumOverRanks(moment);
    }

    outside_ = Zero;
    forAll(force, graini)
    {
        if (grains_.isAtOpening(graini))
        {
            const scalar inside = grains_.mappedVolume()[graini];
            const scalar more = grains_.volume(graini)/inside - 1;

            if (!resolved_.isResolved(graini))
            {
                const vector buoyancy(-inside*rho_.value()*grains_.motion().g());
                torque[graini] -=
                    (moment[graini]/inside) ^ (force[graini] - buoyancy);
                torque[graini] *= 1 + more;
            }
            outside_ += mesh_.time().deltaTValue()*more*force[graini];
            force[graini] *= 1 + more;
        }
    }
}


void Foam::grainFluidExchange::discharge
(
    volVectorField& U,
    surfaceScalarField& phiU
)
{
    const stopwatch::lap lap(time_);
    const std::vector<bool> gone(grains_.leaving());
    const overlapList& overlaps = grains_.overlaps();

    // Volume and flux of volume that the cells lose with the grains
    scalarField share(mesh_.nCells(), Zero);
    vectorField flux(mesh_.nCells(), Zero);
    label nFilled = 0;
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for
        (
            label k = overlaps.start[graini];
            gone[graini] && k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            const scalar w = overlaps.volume[k]/mesh_.V()[celli];
            const vector v
            (
                grains_.motion().velocity(graini, overlaps.arm[k])
            );
            share[celli] += w;
            flux[celli] += w*v;
            ++nFilled;
        }
    }
    grains_.discharge(gone);

    filled_.clear();
    if (!returnReduce(nFilled, sumOp<label>()))
    {
        return;
    }
    grains_.voidFraction().smooth(share);
    grains_.voidFraction().smooth(flux);

    // The fluid that takes their place moves as they did: the mixture's velocity
    // stays, and no pressure is needed to change it
    volVectorField change
    (
        zeroField<vector>("changeOfU", dimVelocity)
    );
    filled_ = -eps_.primitiveField();
    forAll(share, celli)
    {
        const scalar all = eps_[celli] + share[celli];
        if (share[celli] > 0)
        {
            change[celli] = (flux[celli] - share[celli]*U[celli])/all;
        }
    }
    setEps();
    filled_ += eps_.primitiveField();

    change.correctBoundaryConditions();
    U += change;
    U.correctBoundaryConditions();
    phiU += fvc::flux(change);
}


template void Foam::grainFluidExchange::extrapolate(volScalarField&) const;
template void Foam::grainFluidExchange::extrapolate(volVectorField&) const;
