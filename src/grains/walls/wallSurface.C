/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"

#include "dictionaryInput.H"
#include "ListOps.H"
#include "nscd/search/BoxTree.hpp"
#include "OStringStream.H"
#include "sigFpe.H"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

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


// Why an STL file is not whole, empty if it is
string faultOfSTL(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    std::stringstream stream;
    stream << is.rdbuf();
    const std::string text(stream.str());

    OStringStream fault;
    if (text.compare(0, 5, "solid") == 0)
    {
        const auto end = text.find_last_not_of(" \t\r\n");
        const auto line = text.find_last_of('\n', end) + 1;
        if (text.find("endsolid", line) == std::string::npos)
        {
            fault << "it does not end with a line 'endsolid'";
        }
        return fault.str();
    }

    constexpr std::size_t header = 84, triangle = 50;
    if (text.size() < header)
    {
        fault
            << "it has " << label(text.size()) << " bytes, fewer than the header";
        return fault.str();
    }
    std::uint32_t n;
    std::copy_n(text.data() + 80, 4, reinterpret_cast<char*>(&n));
    if (text.size() < header + n*triangle)
    {
        fault
            << "it has " << label(text.size()) << " bytes instead of "
            << scalar(header + n*triangle) << " for " << scalar(n)
            << " triangles";
    }
    return fault.str();
}


void requireFinite
(
    const triSurface& surface,
    const dictionary& dict,
    const fileName& file
)
{
    forAll(surface, i)
    {
        for (const label pointi : surface[i])
        {
            const point& p = surface.points()[pointi];
            if (!std::isfinite(p.x() + p.y() + p.z()))
            {
                OStringStream allowed;
                allowed
                    << "corners of finite coordinates, triangle " << i
                    << " has the corner " << p;
                dictionaryInput::badValue(dict, "file", file, allowed.str());
            }
        }
    }
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


Foam::triSurface Foam::readWallSurface
(
    const dictionary& dict,
    const fileName& file
)
{
    const scalar scale =
        dictionaryInput::getPositiveOrDefault(dict, "scale", dimless, 1);

    const auto refuse = [&](const string& reason)
    {
        dictionaryInput::badValue
        (
            dict, "file", file,
            "a surface of triangles that can be read: " + reason
        );
    };

    if (file.hasExt("stl") || file.hasExt("STL"))
    {
        const string fault(faultOfSTL(file));
        if (fault.size())
        {
            refuse(fault);
        }
    }

    // What is not a number is looked for and reported by name
    const sigFpe::ignore ignoreFpe;

    triSurface surface;
    const string message
    (
        dictionaryInput::errorOf([&] { surface = triSurface(file); })
    );
    if (message.size())
    {
        refuse(message);
    }
    requireFinite(surface, dict, file);

    surface.scalePoints(scale);
    closeGaps(surface);
    return surface;
}
