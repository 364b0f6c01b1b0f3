// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/ball/BallPolyhedron.hpp"

#include "overlap/ball/CellSum.hpp"

namespace overlap
{

namespace
{

/// Contributions of faces that no other cell asks for.
struct FacesOfOneCell
{
    const UnitBall& ball;
    const Facets& facets;

    std::pair<double, double> heights(std::size_t face) const { return heightRange(ball, facets, face); }
    FaceParts parts(std::size_t face) const { return innerParts(ball, facets, face); }
};

}  // namespace

BallOverlap ballPolyhedron(const Point3& centre, double radius, const Polyhedron& cell)
{
    const UnitBall ball = unitBall(centre, radius);
    const CellView view = cell.view();
    const CellShape& shape = view.shape;
    if (!(shape.volume > 0) || !meets(centre, radius, shape.low, shape.high)) return noOverlap(centre);

    const std::vector<Point3>& vertices = cell.vertices();
    if (covers(centre, radius, shape, vertices.size(), [&](std::size_t k) -> const Point3& { return vertices[k]; }))
    {
        return {shape.volume, shape.centroid, 0, Point3::Zero()};
    }

    FacesOfOneCell faces{ball, view.facets};
    return CellSum<FacesOfOneCell>(ball, view, faces).overlap();
}

std::vector<double> ballFaceAreas(const Point3& centre, double radius, const Polyhedron& cell)
{
    const UnitBall ball = unitBall(centre, radius);
    std::vector<double> areas;
    for (std::size_t face = 0; face < cell.nFaces(); ++face)
    {
        areas.push_back(innerParts(ball, cell.view().facets, face).area * radius * radius);
    }
    return areas;
}

}  // namespace overlap
