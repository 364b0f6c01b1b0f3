/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "resolvedBySize.H"

#include "combineOverRanks.H"


Foam::boolList Foam::resolvedBySize
(
    const grainSystem& grains,
    const scalarField& cellSize,
    const scalar from
)
{
    // A grain of just as many cells must not change with the round-off of its overlaps
    const scalar least = (1 - 1e-6)*from;

    const overlapList& overlaps = grains.overlaps();
    scalarField size(grains.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            size[graini] += o.volume*cellSize[o.cell];
        }
    }
    sumOverRanks(size);

    boolList result(grains.size());
    forAll(result, graini)
    {
        result[graini] =
            size[graini] > 0
         && grains.fluidDiameter(graini)*grains.mappedVolume()[graini]
         >= least*size[graini];
    }
    return result;
}
