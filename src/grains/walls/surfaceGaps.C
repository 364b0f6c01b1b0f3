/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceGaps.H"

#include "ListOps.H"
#include "nscd/search/BoxTree.hpp"

#include <algorithm>
#include <map>

namespace
{

using namespace Foam;

// Over the largest distance from the origin
constexpr scalar sameCorner = 1e-6;
constexpr scalar onEdge = 1e-12;

nscd::Vector<3> toVector(const point& p)
{
    return {p.x(), p.y(), p.z()};
}


// The surface with one point for those not farther apart than 'same', without
// the triangles that have lost a corner by it
triSurface welded(const triSurface& surface, const scalar same)
{
    // Along a line on which few points of a drawing have the same place
    const vector line(0.6113, 0.5387, 0.5797);
    const pointField& points = surface.points();
    labelList order;
    sortedOrder(scalarField(points & line), order);

    labelList first(points.size(), label(-1));
    forAll(order, i)
    {
        const point& p = points[order[i]];
        for
        (
            label j = i;
            j < order.size() && ((points[order[j]] - p) & line) <= 2*same;
            ++j
        )
        {
            if (first[order[j]] < 0 && mag(points[order[j]] - p) <= same)
            {
                first[order[j]] = order[i];
            }
        }
    }

    // A point that is another's is no first one: the chain ends at one that is
    DynamicList<labelledTri> triangles;
    for (const labelledTri& tri : surface)
    {
        labelledTri t(tri);
        for (label& pointi : t)
        {
            while (first[pointi] != pointi)
            {
                pointi = first[pointi];
            }
        }
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
            triangles.append(t);
        }
    }
    return triSurface(triangles, points);
}


// Edges of one triangle only
List<edge> freeEdges(const triSurface& surface)
{
    std::map<std::pair<label, label>, label> count;
    for (const labelledTri& tri : surface)
    {
        forAll(tri, i)
        {
            ++count[std::minmax(tri[i], tri[tri.fcIndex(i)])];
        }
    }
    DynamicList<edge> result;
    for (const auto& one : count)
    {
        if (one.second == 1)
        {
            result.append(edge(one.first.first, one.first.second));
        }
    }
    return List<edge>(std::move(result));
}


// Move corners of free edges that lie beside another one on to it; the largest
// distance [m]
scalar moveOnEdges
(
    pointField& points,
    const List<edge>& edges,
    const scalar same
)
{
    std::vector<label> corners;
    for (const edge& e : edges)
    {
        corners.insert(corners.end(), {e.first(), e.second()});
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());

    std::vector<nscd::Bounds<3>> boxes;
    for (const label c : corners)
    {
        boxes.push_back({toVector(points[c]), toVector(points[c])});
    }
    const nscd::BoxTree<3> tree(boxes, std::vector<int>(boxes.size(), 0));

    scalar farthest = 0;
    for (const edge& e : edges)
    {
        const point from(points[e.first()]);
        const vector along(points[e.second()] - from);
        const scalar length = mag(along);
        const nscd::Vector<3> reach(nscd::Vector<3>::Constant(2*same));
        nscd::Bounds<3> near{toVector(from), toVector(from)};
        near.enclose({toVector(from + along), toVector(from + along)});
        near = {near.lower - reach, near.upper + reach};

        tree.forMeeting
        (
            near,
            [&](const int i)
            {
                point& x = points[corners[i]];
                const scalar s = ((x - from) & along)/length;
                if
                (
                    corners[i] == e.first() || corners[i] == e.second()
                 || s <= same || s >= length - same
                )
                {
                    return;
                }
                const point foot(from + s/length*along);
                const scalar distance = mag(x - foot);
                if (distance <= same)
                {
                    farthest = max(farthest, distance);
                    x = foot;
                }
            }
        );
    }
    return farthest;
}

}


void Foam::closeGaps(triSurface& surface)
{
    if (surface.empty())
    {
        return;
    }
    const scalar size = Foam::sqrt(max(magSqr(surface.points())));
    surface = welded(surface, sameCorner*size);

    const List<edge> edges(freeEdges(surface));
    pointField points(surface.points());

    // Edges can end on one another
    for (label i = 0; i < 100; ++i)
    {
        if (moveOnEdges(points, edges, sameCorner*size) <= onEdge*size)
        {
            break;
        }
    }
    surface.movePoints(points);
}
