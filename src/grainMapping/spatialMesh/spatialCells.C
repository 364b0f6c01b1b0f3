/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spatialCells.H"

#include "mathematicalConstants.H"
#include "spatialMesh.H"

namespace
{

using namespace Foam;

overlap::Point3 toEigen(const point& p)
{
    return overlap::Point3(p.x(), p.y(), p.z());
}


void append
(
    const std::vector<overlap::CellOverlap>& parts,
    const overlap::Point3& centre,
    overlapList& overlaps
)
{
    for (const overlap::CellOverlap& part : parts)
    {
        const overlap::Point3 arm(part.centroid - centre);
        overlaps.append(part.cell, part.volume, vector(arm[0], arm[1], arm[2]));
    }
}

}


Foam::spatialCells::spatialCells(const fvMesh& mesh)
:
    mesh_(mesh),
    cells_(spatialMesh::New(mesh))
{}


Foam::scalar Foam::spatialCells::volume(const scalar radius) const
{
    return 4.0/3.0*constant::mathematical::pi*pow3(radius);
}


bool Foam::spatialCells::isWithinBounds(const grainMember& sphere) const
{
    const vector corner(vector::one*sphere.radius);
    return
        mesh_.bounds().contains(sphere.centre - corner)
     && mesh_.bounds().contains(sphere.centre + corner);
}


void Foam::spatialCells::appendOverlaps
(
    const grainMember& sphere,
    const label hint,
    overlapList& overlaps
) const
{
    const overlap::Point3 centre(toEigen(sphere.centre));
    append
    (
        cells_.ball().overlaps(centre, sphere.radius, hint),
        centre, overlaps
    );
}


void Foam::spatialCells::appendOverlaps
(
    const UList<grainMember>& members,
    const point& centre,
    overlapList& overlaps
) const
{
    std::vector<overlap::Sphere<3>> balls;
    for (const grainMember& m : members)
    {
        balls.push_back({toEigen(m.centre), m.radius});
    }

    forAll(members, i)
    {
        if (const auto cuts = overlap::powerCell(balls, i))
        {
            append
            (
                cells_.ball().overlaps
                (
                    balls[i].centre, balls[i].radius, *cuts
                ),
                toEigen(centre), overlaps
            );
        }
    }
}


void Foam::spatialCells::findNear
(
    const grainMember& sphere,
    DynamicList<label>& cells
) const
{
    cells.clear();
    const auto take = [&](const int celli)
    {
        cells.append(celli);
        return true;
    };
    cells_.cells().tree().forCells
    (
        toEigen(sphere.centre), sphere.radius, take, take
    );
}


Foam::vectorField Foam::spatialCells::pairsOfPoints(const label nPairs) const
{
    // Equal volumes within the radii; angle and height by Kronecker's sequence
    // of the plastic number's inverse and its square, even in a half sphere
    const scalar plastic = 1.32471795724474602596;

    vectorField points(2*nPairs);
    for (label i = 0; i < nPairs; ++i)
    {
        const scalar r = std::cbrt((i + 0.5)/nPairs);
        const scalar turns = (i + 0.5)/plastic;
        const scalar steps = (i + 0.5)/sqr(plastic);
        const scalar angle =
            constant::mathematical::twoPi*(turns - std::floor(turns));
        const scalar z = steps - std::floor(steps);
        const scalar across = std::sqrt(1 - sqr(z));
        points[2*i] = r*vector(across*std::cos(angle), across*std::sin(angle), z);
        points[2*i + 1] = -points[2*i];
    }
    return points;
}
