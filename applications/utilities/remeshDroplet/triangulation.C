/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangulation.H"

#include "mathematicalConstants.H"
#include "overlap/base/Types.hpp"
#include "sigFpe.H"

#include <gmsh.h>

#include <map>
#include <unordered_map>

namespace
{

using namespace Foam;
namespace geo = gmsh::model::geo;
namespace sizeField = gmsh::model::mesh::field;

//- Sides whose lengths are within a factor of two of each other
struct sameSides
{
    std::vector<double> lines;

    double length = 0;
};

typedef std::map<int, sameSides> sidesByLength;


//- A closed line through points, one element a side
int closedLine
(
    const std::vector<int>& points,
    const std::vector<planarMesh::point2>& x,
    sidesByLength& sides
)
{
    std::vector<int> loop;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
    {
        const std::size_t next = (i + 1) % n;
        const int line = geo::addLine(points[i], points[next]);
        geo::mesh::setTransfiniteCurve(line, 2);
        loop.push_back(line);

        const double length = (x[next] - x[i]).norm();
        sameSides& group = sides[std::ilogb(length)];
        group.lines.push_back(line);
        group.length += length;
    }
    return geo::addCurveLoop(loop);
}


//- The node of a point
std::size_t nodeOf(const int point)
{
    std::vector<std::size_t> tags;
    std::vector<double> x, parameters;
    gmsh::model::mesh::getNodes(tags, x, parameters, 0, point);
    return tags.at(0);
}


//- Cells are as large as the sides beside them, larger away from them
void setSizes(const sidesByLength& sides, const double growth, const double most)
{
    std::vector<double> ramps;
    for (const auto& group : sides)
    {
        const std::vector<double>& lines = group.second.lines;
        const double least =
            std::min(group.second.length/lines.size(), most);
        const int distance = sizeField::add("Distance");
        sizeField::setNumbers(distance, "CurvesList", lines);
        sizeField::setNumber(distance, "NumPointsPerCurve", 3);
        const int ramp = sizeField::add("Threshold");
        sizeField::setNumber(ramp, "InField", distance);
        sizeField::setNumber(ramp, "SizeMin", least);
        sizeField::setNumber(ramp, "SizeMax", most);
        sizeField::setNumber(ramp, "DistMin", 0);
        sizeField::setNumber(ramp, "DistMax", (most - least)/growth + 1e-9);
        ramps.push_back(ramp);
    }
    const int least = sizeField::add("Min");
    sizeField::setNumbers(least, "FieldsList", ramps);
    sizeField::setAsBackgroundMesh(least);
    for (const char* other : {"ExtendFromBoundary", "FromPoints", "FromCurvature"})
    {
        gmsh::option::setNumber(std::string("Mesh.MeshSize") + other, 0);
    }
}

}


Foam::triangulation::triangulation
(
    const planarOutline& outline,
    const circle& hole,
    const sizes& size
)
{
    // Its front divides by zero where sides are many
    const sigFpe::ignore ignoreFpe;
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::model::add("droplet");

    // In units of the circle, as tolerances of gmsh are absolute
    std::vector<planarMesh::point2> x;
    for (const planarMesh::point2& corner : outline.points())
    {
        x.emplace_back((corner - hole.centre)/hole.radius);
    }
    const int nAround =
        round(constant::mathematical::twoPi*hole.radius/size.least);
    for (int i = 0; i < nAround; ++i)
    {
        const scalar angle = constant::mathematical::twoPi*i/nAround;
        x.emplace_back(std::cos(angle), std::sin(angle));
    }
    std::vector<int> corners;
    for (const planarMesh::point2& corner : x)
    {
        corners.push_back(geo::addPoint(corner[0], corner[1], 0));
    }

    sidesByLength sides;
    std::vector<int> loops;
    labelListList lines(outline.loops());
    lines.append(identity(nAround, outline.points().size()));
    for (const labelList& line : lines)
    {
        std::vector<int> points;
        std::vector<planarMesh::point2> places;
        for (const label i : line)
        {
            points.push_back(corners[i]);
            places.push_back(x[i]);
        }
        loops.push_back(closedLine(points, places, sides));
    }
    geo::addPlaneSurface(loops);
    geo::addPlaneSurface({loops.back()});
    geo::synchronize();
    setSizes(sides, size.growth, size.most/hole.radius);
    gmsh::option::setNumber("Mesh.Algorithm", 6);
    try
    {
        gmsh::model::mesh::generate(2);
    }
    catch (const std::string& reason)
    {
        FatalErrorInFunction
            << "gmsh finds no triangles around the droplet of radius "
            << hole.radius << " m: " << reason.c_str() << nl
            << "    allowed: boundaries that cross neither themselves nor the"
            << " droplet" << exit(FatalError);
    }

    std::unordered_map<std::size_t, label> indices;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        indices[nodeOf(corners[i])] = i;
    }
    points_ = outline.points();
    points_.resize(corners.size());

    std::vector<std::size_t> tags;
    std::vector<double> nodeX, parameters;
    gmsh::model::mesh::getNodes(tags, nodeX, parameters);
    for (std::size_t i = 0; i < tags.size(); ++i)
    {
        const planarMesh::point2 at
        (
            hole.centre
          + hole.radius*planarMesh::point2(nodeX[3*i], nodeX[3*i + 1])
        );
        const auto known = indices.emplace(tags[i], points_.size());
        if (known.second)
        {
            points_.push_back(at);
        }
        else if (known.first->second >= label(outline.points().size()))
        {
            points_[known.first->second] = at;
        }
    }

    std::vector<std::size_t> elements, nodes;
    gmsh::model::mesh::getElementsByType(2, elements, nodes);
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
        FixedList<label, 3> t;
        for (label k = 0; k < 3; ++k)
        {
            t[k] = indices.at(nodes[3*i + k]);
        }
        if
        (
            overlap::cross
            (
                points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]
            ) < 0
        )
        {
            std::swap(t[1], t[2]);
        }
        triangles_.push_back(t);
    }
    gmsh::finalize();
}
