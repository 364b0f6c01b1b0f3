/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactOverlap.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace voidFractionMethods
{
    defineTypeNameAndDebug(exactOverlap, 0);
    addToRunTimeSelectionTable(voidFractionMethod, exactOverlap, dictionary);
}
}


Foam::voidFractionMethods::exactOverlap::exactOverlap
(
    const dictionary& dict,
    const grainCells& cells
)
:
    voidFractionMethod(cells)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


void Foam::voidFractionMethods::exactOverlap::map
(
    const grainBodies& grains,
    overlapList& overlaps
) const
{
    const overlapList last(overlaps.renew());

    forAll(grains.centre, graini)
    {
        const SubList<grainMember> members(grains.members(graini));
        if (members.size() == 1)
        {
            cells_.appendOverlaps(members[0], hint(last, graini), overlaps);
        }
        else
        {
            cells_.appendOverlaps(members, grains.centre[graini], overlaps);
        }
        overlaps.endGrain();
    }
}
