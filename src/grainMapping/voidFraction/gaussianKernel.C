/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gaussianKernel.H"

#include "addToRunTimeSelectionTable.H"
#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "volFields.H"

namespace Foam
{
namespace voidFractionMethods
{
    defineTypeNameAndDebug(gaussianKernel, 0);
    addToRunTimeSelectionTable(voidFractionMethod, gaussianKernel, dictionary);
}
}


Foam::voidFractionMethods::gaussianKernel::gaussianKernel
(
    const dictionary& dict,
    const grainCells& cells
)
:
    voidFractionMethod(cells),
    width_(dictionaryInput::getScalar(dict, "width", dimless, 0.01, 100))
{
    dictionaryInput::checkKeywords(dict, {"type", "width"});
}


void Foam::voidFractionMethods::gaussianKernel::map
(
    const grainBodies& grains,
    overlapList& overlaps
) const
{
    const volVectorField& C = cells_.mesh().C();
    const scalarField& V = cells_.mesh().V();

    const overlapList last(overlaps.renew());
    overlapList weights;
    weights.clear();
    scalarField total(grains.size(), Zero);
    DynamicList<label> near;

    forAll(grains.centre, graini)
    {
        const point& x = grains.centre[graini];
        const scalar b = 2*width_*grains.radius[graini];

        cells_.findNear({x, 3*b}, near);
        for (const label celli : near)
        {
            const scalar distance2 = magSqr(cells_.shortest(C[celli] - x));
            if (distance2 < sqr(3*b))
            {
                const scalar w = V[celli]*Foam::exp(-distance2/sqr(b));
                weights.append(celli, w, Zero);
                total[graini] += w;
            }
        }
        weights.endGrain();
    }
    sumOverRanks(total);

    forAll(grains.centre, graini)
    {
        const scalar radius = grains.radius[graini];
        const scalar volume = cells_.volume(radius);

        if (total[graini] > 0)
        {
            for
            (
                label k = weights.start[graini];
                k < weights.start[graini + 1];
                ++k
            )
            {
                overlaps.append
                (
                    weights.cell[k],
                    weights.volume[k]/total[graini]*volume,
                    Zero
                );
            }
        }
        else
        {
            appendPoint
            (
                grains.centre[graini], radius, volume, Zero,
                hint(last, graini), overlaps
            );
        }
        overlaps.endGrain();
    }
}
