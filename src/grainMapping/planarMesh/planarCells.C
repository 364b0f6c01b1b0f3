/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarCells.H"

#include "mathematicalConstants.H"
#include "overlap/clip/Clip.hpp"
#include "overlap/disc/DiscPolygon.hpp"

Eigen::AlignedBox2d Foam::planarCells::box(const grainMember& disc) const
{
    const planarMesh::point2 centre(plane_.toPlane(disc.centre));
    const planarMesh::point2 corner(disc.radius, disc.radius);
    return {centre - corner, centre + corner};
}


Foam::scalar Foam::planarCells::volume(const scalar radius) const
{
    return constant::mathematical::pi*sqr(radius)*plane_.depth();
}


bool Foam::planarCells::isWithinBounds(const grainMember& disc) const
{
    return plane_.globalDomain().contains(box(disc));
}


bool Foam::planarCells::appendNear
(
    const grainMember& disc,
    const label hint,
    overlapList& overlaps
) const
{
    // Beyond it, what is cut off is too small for the difference below
    constexpr scalar largestDistance = 0.999;

    const planarMesh::point2 centre(plane_.toPlane(disc.centre));
    const scalar r = disc.radius;

    const label celli = plane_.findCell(centre, hint);
    if (celli < 0)
    {
        return false;
    }

    const planarMesh::approach here(plane_.near(celli, centre, r));
    if (here.nClose == 0)
    {
        overlaps.append(celli, volume(r), Zero);
        return true;
    }

    const scalar h = here.distance/r;
    if
    (
        here.nClose > 1 || here.neighbour < 0 || h < 0 || h > largestDistance
     || plane_.near(here.neighbour, centre, r).nClose > 1
    )
    {
        return false;
    }

    // Circular segments of a unit disc on both sides of the edge
    const scalar halfChord = std::sqrt((1 - h)*(1 + h));
    const scalar beyond = std::atan2(halfChord, h) - h*halfChord;
    const scalar within = constant::mathematical::pi - beyond;
    const scalar moment = 2.0/3.0*pow3(halfChord);

    const scalar unit = sqr(r)*plane_.depth();
    const vector arm(plane_.toSpace(r*moment*here.normal));
    overlaps.append(celli, within*unit, arm/within);
    overlaps.append(here.neighbour, beyond*unit, -arm/beyond);
    return true;
}


void Foam::planarCells::appendOverlaps
(
    const grainMember& disc,
    const label hint,
    overlapList& overlaps
) const
{
    if (appendNear(disc, hint, overlaps))
    {
        return;
    }

    const planarMesh::point2 centre(plane_.toPlane(disc.centre));

    plane_.forCells
    (
        box(disc),
        [&](const label celli)
        {
            const overlap::AreaMoment part = overlap::discPolygon
            (
                centre, disc.radius,
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
}


void Foam::planarCells::appendOverlaps
(
    const UList<grainMember>& members,
    const point& centre,
    overlapList& overlaps
) const
{
    std::vector<overlap::Sphere<2>> discs;
    for (const grainMember& m : members)
    {
        discs.push_back({plane_.toPlane(m.centre), m.radius});
    }

    forAll(members, i)
    {
        const auto cuts = overlap::powerCell(discs, i);
        if (!cuts)
        {
            continue;
        }
        plane_.forCells
        (
            box(members[i]),
            [&](const label celli)
            {
                const planarMesh::point2* vertices = plane_.polygon(celli);
                std::vector<planarMesh::point2> cell
                (
                    vertices, vertices + plane_.polygonSize(celli)
                );
                for (const overlap::HalfSpace<2>& half : *cuts)
                {
                    cell = overlap::clipped(cell, half);
                }
                if (cell.size() < 3)
                {
                    return;
                }
                const overlap::AreaMoment part = overlap::discPolygon
                (
                    discs[i].centre, discs[i].radius, cell.data(), cell.size()
                );
                if (part.area > 0)
                {
                    overlaps.append
                    (
                        celli,
                        part.area*plane_.depth(),
                        plane_.toSpace(part.centroid - plane_.toPlane(centre))
                    );
                }
            }
        );
    }
}


void Foam::planarCells::findNear
(
    const grainMember& disc,
    DynamicList<label>& cells
) const
{
    cells.clear();
    plane_.forCells(box(disc), [&](const label celli) { cells.append(celli); });
}


Foam::vectorField Foam::planarCells::pairsOfPoints(const label nPairs) const
{
    // Sunflower: equal areas within the radii, directions by the golden angle,
    // which the other half of the circle repeats
    const scalar goldenAngle = constant::mathematical::pi*(3 - std::sqrt(5.0));

    vectorField points(2*nPairs);
    for (label i = 0; i < nPairs; ++i)
    {
        const scalar r = std::sqrt((i + 0.5)/nPairs);
        const scalar angle = 0.5*i*goldenAngle;
        points[2*i] = plane_.toSpace({r*std::cos(angle), r*std::sin(angle)});
        points[2*i + 1] = -points[2*i];
    }
    return points;
}
