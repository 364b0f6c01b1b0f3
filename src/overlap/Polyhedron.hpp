// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/BallOverlap.hpp"
#include "overlap/CellShape.hpp"

#include <vector>

namespace overlap
{

/// A closed polyhedron, convex or not, prepared for the overlap with many balls.
class Polyhedron
{
public:
    /// Faces are simple polygons, given by indices of vertices, counter-clockwise seen from outside; each edge belongs
    /// to two faces.  A face whose vertices are not in a plane is a fan of triangles about their average.
    /// Throws std::invalid_argument if an index is out of range, a coordinate is not finite, the faces do not close or
    /// the volume is not positive.
    Polyhedron(const std::vector<Point3>& vertices, const std::vector<std::vector<int>>& faces);

    double volume() const { return shape_.volume; }             ///< [m^3]
    const Point3& centroid() const { return shape_.centroid; }  ///< [m]
    std::size_t nFaces() const { return faces_.size(); }

    CellView view() const { return {facets_, shape_, faces_.data(), faces_.size()}; }
    const std::vector<Point3>& vertices() const { return vertices_; }

private:
    std::vector<Point3> vertices_;
    Facets facets_;
    std::vector<CellFace> faces_;
    CellShape shape_;
};

}  // namespace overlap
