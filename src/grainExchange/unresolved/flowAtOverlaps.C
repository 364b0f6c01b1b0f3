/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAtOverlaps.H"

#include "gradScheme.H"

Foam::scalar Foam::flowAtOverlaps::share(const scalar dOverH)
{
    return min(max(-1 - std::log2(dOverH), scalar(0)), scalar(1));
}


void Foam::flowAtOverlaps::set
(
    const grainSystem& grains,
    const resolvedTerm& resolved,
    const scalarField& cellSize,
    const volVectorField& U
)
{
    const overlapList& overlaps = grains.overlaps();
    velocity_.resize(overlaps.size());
    velocity_ = Zero;

    bool isSmall = false;
    const scalar largest = gMax(cellSize);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        isSmall =
            isSmall
         || (
                !resolved.isResolved(graini)
             && share(grains.fluidDiameter(graini)/largest) > 0
            );
    }
    if (!returnReduce(isSmall, orOp<bool>()))
    {
        return;
    }

    // No face is beyond the values of the cells around
    ITstream scheme("limited", string("cellLimited Gauss linear 1"));
    const tmp<volTensorField> gradU
    (
        fv::gradScheme<vector>::New(grains.mesh(), scheme)().calcGrad(U, "limited")
    );
    const vectorField& C = grains.mesh().C();
    tmp<volScalarField> open;
    if (resolved.leavesParts())
    {
        open = resolved.open();
    }

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (resolved.isResolved(graini))
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            const scalar part =
                resolved.isLiquid(o.cell) || (open && open()[o.cell] < 1)
              ? 0
              : share(grains.fluidDiameter(graini)/cellSize[o.cell]);
            const vector way
            (
                o.arm - grains.shortest(C[o.cell] - grains.centres()[graini])
            );
            velocity_[o.index] = part*(way & gradU()[o.cell]);
        }
    }
}
