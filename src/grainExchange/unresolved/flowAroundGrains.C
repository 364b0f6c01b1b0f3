/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAroundGrains.H"

#include "combineOverRanks.H"

Foam::List<Foam::flowAround> Foam::flowAroundGrains
(
    const grainSystem& grains,
    const carrier& fluid,
    const scalarField& weight,
    const scalarField& cellSize,
    const symmTensorField& section,
    const scalarField& eps,
    const vectorField& U,
    const filteredFlow& filtered
)
{
    const scalarField& V = grains.mesh().V();
    const overlapList& overlaps = grains.overlaps();

    List<flowAround> result(grains.size());
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        flowAround& sum = result[graini];
        for (const cellOverlap& o : overlaps.of(graini))
        {
            if (weight[o.cell] == 0)
            {
                continue;
            }
            sum.volume += o.volume;
            sum.rho += o.volume*fluid.rho()[o.cell];
            sum.mu += o.volume*fluid.mu()[o.cell];
            sum.cellSize += o.volume*cellSize[o.cell];
            sum.section += o.volume*section[o.cell];
            sum.ownShare += o.volume*o.volume/V[o.cell];
            sum.eps += o.volume*eps[o.cell];
            sum.filteredEps += o.volume*filtered.eps[o.cell];
            sum.U += o.volume*U[o.cell];
            sum.filteredU += o.volume*filtered.U[o.cell];
            sum.excessGradP += o.volume*filtered.excessGradP[o.cell];
        }
    }
    sumRecordsOverRanks(grains.shared(), result);

    for (flowAround& mean : result)
    {
        const scalar volume = max(mean.volume, VSMALL);
        mean.rho /= volume;
        mean.mu /= volume;
        mean.cellSize /= volume;
        mean.section /= volume;
        mean.ownShare /= volume;
        mean.eps /= volume;
        mean.filteredEps /= volume;
        mean.U /= volume;
        mean.filteredU /= volume;
        mean.excessGradP /= volume;
    }
    return result;
}
