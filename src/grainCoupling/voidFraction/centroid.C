/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "centroid.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "mathematicalConstants.H"
#include "planarMesh.H"

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
    const planarMesh& plane
)
:
    voidFractionMethod(plane),
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
    const pointField& centres,
    const scalarField& radii,
    overlapList& overlaps
) const
{
    overlaps.clear();

    forAll(centres, graini)
    {
        const label celli = plane_.findCell(plane_.toPlane(centres[graini]));

        if (celli >= 0)
        {
            overlaps.append
            (
                celli,
                constant::mathematical::pi*sqr(radii[graini])*plane_.depth(),
                Zero
            );
        }
        overlaps.endGrain();
    }
}
