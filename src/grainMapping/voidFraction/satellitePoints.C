/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "satellitePoints.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace voidFractionMethods
{
    defineTypeNameAndDebug(satellitePoints, 0);
    addToRunTimeSelectionTable(voidFractionMethod, satellitePoints, dictionary);
}
}


namespace
{

using namespace Foam;

// Is a point of member i also in one of larger power there, see PowerCell.hpp?
bool isAnothers
(
    const point& x,
    const UList<grainMember>& members,
    const label i
)
{
    const auto power = [&](const grainMember& m)
    {
        return magSqr(x - m.centre) - sqr(m.radius);
    };
    forAll(members, j)
    {
        if (j != i && power(members[j]) < power(members[i]))
        {
            return true;
        }
    }
    return false;
}

}


Foam::voidFractionMethods::satellitePoints::satellitePoints
(
    const dictionary& dict,
    const grainCells& cells
)
:
    voidFractionMethod(cells),
    points_
    (
        cells.pairsOfPoints
        (
            dictionaryInput::getLabelOrDefault(dict, "pairs", 16, 1, 1000000)
        )
    )
{
    dictionaryInput::checkKeywords(dict, {"type", "pairs"});
}


void Foam::voidFractionMethods::satellitePoints::place
(
    const UList<grainMember>& members,
    DynamicList<satellite>& satellites
) const
{
    satellites.clear();
    scalar total = 0;
    forAll(members, i)
    {
        const scalar weight = cells_.volume(members[i].radius);
        for (const vector& unit : points_)
        {
            const point x(members[i].centre + members[i].radius*unit);
            if (!isAnothers(x, members, i))
            {
                satellites.append({x, weight});
                total += weight;
            }
        }
    }
    for (satellite& s : satellites)
    {
        s.weight /= total;
    }
}


void Foam::voidFractionMethods::satellitePoints::map
(
    const grainBodies& grains,
    overlapList& overlaps
) const
{
    const overlapList last(overlaps.renew());
    DynamicList<satellite> satellites;

    forAll(grains.centre, graini)
    {
        const scalar radius = grains.radius[graini];
        const scalar volume = cells_.volume(radius);

        place(grains.members(graini), satellites);
        for (const satellite& s : satellites)
        {
            appendPoint
            (
                s.position, radius, s.weight*volume,
                s.position - grains.centre[graini],
                hint(last, graini), overlaps
            );
        }
        overlaps.endGrain();
    }
}
