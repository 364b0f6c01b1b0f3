/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAroundGrains.H"

#include "combineOverRanks.H"

void Foam::flowAround::restoreBed(const vector& v)
{
    // Among grains at random the filtered fraction varies by less
    constexpr scalar least = 0.08, full = 0.14;

    const scalar phi = max(1 - filteredEps, SMALL);
    const scalar jump = mag(epsJump);
    const scalar part =
        min(max((jump/phi - least)/(full - least), scalar(0)), scalar(1));
    const scalar ofCells = max(phi, 1 - eps);
    const scalar ofBed = min(phi + part*jump, ofCells);
    const scalar restored = (ofBed - phi)/max(ofCells - phi, SMALL);

    filteredU = v + filteredEps/max(1 - ofBed, SMALL)*(filteredU - v);
    filteredGradP += restored*(gradP - filteredGradP);
    filteredEps = 1 - ofBed;
}


Foam::List<Foam::flowAround> Foam::flowAroundGrains
(
    const grainSystem& grains,
    const carrier& fluid,
    const scalarField& weight,
    const scalarField& cellSize,
    const symmTensorField& section,
    const scalarField& eps,
    const vectorField& U,
    const vectorField& gradP,
    const flowAtOverlaps& at,
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
            sum.ownShare += o.volume*o.volume/(V[o.cell]*weight[o.cell]);
            sum.eps += o.volume*eps[o.cell];
            sum.filteredEps += o.volume*filtered.eps[o.cell];
            sum.epsJump += o.volume*filtered.epsJump[o.cell];
            sum.U += o.volume*(U[o.cell] + at.velocity(o));
            sum.filteredU += o.volume*filtered.U[o.cell];
            sum.gradP += o.volume*gradP[o.cell];
            sum.filteredGradP += o.volume*filtered.gradP[o.cell];
        }
    }
    sumRecordsOverRanks(grains.shared(), result);

    forAll(result, graini)
    {
        flowAround& mean = result[graini];
        const scalar volume = max(mean.volume, VSMALL);
        mean.rho /= volume;
        mean.mu /= volume;
        mean.cellSize /= volume;
        mean.section /= volume;
        mean.ownShare /= volume;
        mean.eps /= volume;
        mean.filteredEps /= volume;
        mean.epsJump /= volume;
        mean.U /= volume;
        mean.filteredU /= volume;
        mean.gradP /= volume;
        mean.filteredGradP /= volume;
        mean.restoreBed(grains.motion().velocity(graini));
    }
    return result;
}
