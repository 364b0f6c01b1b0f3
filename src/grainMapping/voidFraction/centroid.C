/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "centroid.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace voidFractionMethods
{
    defineTypeNameAndDebug(centroid, 0);
    addToRunTimeSelectionTable(voidFractionMethod, centroid, dictionary);
}
}


Foam::voidFractionMethods::centroid::centroid
(
    const dictionary& dict,
    const grainCells& cells
)
:
    voidFractionMethod(cells),
    pressureDiffusion_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict, "pressureDiffusion", dimless, 0, 0
        )
    )
{
    dictionaryInput::checkKeywords(dict, {"type", "pressureDiffusion"});
}


void Foam::voidFractionMethods::centroid::map
(
    const grainBodies& grains,
    overlapList& overlaps
) const
{
    const overlapList last(overlaps.renew());

    forAll(grains.centre, graini)
    {
        appendPoint
        (
            grains.centre[graini], grains.radius[graini],
            cells_.volume(grains.radius[graini]), Zero,
            hint(last, graini), overlaps
        );
        overlaps.endGrain();
    }
}
