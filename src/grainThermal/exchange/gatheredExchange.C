/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gatheredExchange.H"

#include "combineOverRanks.H"

namespace
{

using namespace Foam;

//- m in cells of h/d of a grain in a bed
scalar powerIn(const scalar hOverD)
{
    constexpr scalar most = 32, none = 0.7, all = 1;
    const scalar part = (hOverD - none)/(all - none);
    return 1 + (most - 1)*min(max(part, scalar(0)), scalar(1));
}

}


void Foam::gatherExchange
(
    const grainSystem& grains,
    const scalarField& cellSize,
    const scalarField& lone,
    scalarField& conductance
)
{
    const overlapList& overlaps = grains.overlaps();
    const auto forOverlaps = [&](const auto& f)
    {
        for (label graini = 0; graini < overlaps.nGrains(); ++graini)
        {
            for (const cellOverlap& o : overlaps.of(graini))
            {
                f(graini, o);
            }
        }
    };

    scalarField whole(grains.size(), Zero), size(grains.size(), Zero);
    forOverlaps
    (
        [&](const label graini, const cellOverlap& o)
        {
            whole[graini] += conductance[o.index];
            size[graini] += conductance[o.index]*cellSize[o.cell];
        }
    );
    sumOverRanks(whole);
    sumOverRanks(size);

    const auto gathered = [&](const label graini, const cellOverlap& o)
    {
        if (whole[graini] <= 0)
        {
            return scalar(0);
        }
        const scalar h = size[graini]/whole[graini];
        const scalar m =
            lone[graini]
          + (1 - lone[graini])*powerIn(h/grains.fluidDiameter(graini));
        return std::pow(conductance[o.index]/whole[graini], m);
    };
    scalarField sum(grains.size(), Zero);
    forOverlaps
    (
        [&](const label graini, const cellOverlap& o)
        {
            sum[graini] += gathered(graini, o);
        }
    );
    sumOverRanks(sum);
    forOverlaps
    (
        [&](const label graini, const cellOverlap& o)
        {
            if (sum[graini] > 0)
            {
                conductance[o.index] = whole[graini]*gathered(graini, o)/sum[graini];
            }
        }
    );
}
