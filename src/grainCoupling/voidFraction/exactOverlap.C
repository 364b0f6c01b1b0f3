/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactOverlap.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "overlap/DiscPolygon.hpp"
#include "planarMesh.H"

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
    const planarMesh& plane
)
:
    voidFractionMethod(plane)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


void Foam::voidFractionMethods::exactOverlap::map
(
    const pointField& centres,
    const scalarField& radii,
    overlapList& overlaps
) const
{
    overlaps.clear();

    forAll(centres, graini)
    {
        const planarMesh::point2 centre(plane_.toPlane(centres[graini]));
        const scalar radius = radii[graini];
        const planarMesh::point2 corner(radius, radius);

        plane_.forCells
        (
            Eigen::AlignedBox2d(centre - corner, centre + corner),
            [&](const label celli)
            {
                const overlap::AreaMoment part = overlap::discPolygon
                (
                    centre, radius,
                    plane_.polygon(celli), plane_.polygonSize(celli)
                );

                if (part.area > 0)
                {
                    overlaps.append
                    (
                        celli,
                        part.area*plane_.depth(),
                        plane_.toSpace(part.centroid - centre)
                    );
                }
            }
        );
        overlaps.endGrain();
    }
}
