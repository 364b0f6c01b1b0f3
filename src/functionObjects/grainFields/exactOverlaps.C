/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactOverlaps.H"

#include "periodicCells.H"

Foam::overlapList Foam::functionObjects::exactOverlaps(const grainMotion& grains)
{
    const autoPtr<grainCells> cells(periodicCells::New(grains.cells()));
    const grainBodies bodies(grains.bodies());
    overlapList overlaps;
    overlaps.clear();
    for (label graini = 0; graini < bodies.size(); ++graini)
    {
        const SubList<grainMember> members(bodies.members(graini));
        if (members.size() == 1)
        {
            cells->appendOverlaps(members[0], -1, overlaps);
        }
        else
        {
            cells->appendOverlaps(members, bodies.centre[graini], overlaps);
        }
        overlaps.endGrain();
    }
    return overlaps;
}
