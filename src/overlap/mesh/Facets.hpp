// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/Types.hpp"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace overlap
{

/// A plane polygon, counter-clockwise about its normal, with a frame in its plane: tangent and normal x tangent.
struct alignas(64) Facet
{
    Point3 origin, normal;     ///< with begin and end one line of cache: all that most balls ask for
    std::uint32_t begin, end;  ///< its vertices
    Point3 tangent;
    Point2 low, high;  ///< bounds of the vertices in the frame

    Point2 inFrame(const Point3& x) const
    {
        const Point3 d = x - origin;
        return {tangent.dot(d), normal.cross(tangent).dot(d)};
    }
};

/// Faces of polyhedra, prepared once for the overlap with many balls.
///
/// A face whose vertices lie in a plane, to within the rounding of their coordinates, is one facet.  Any other is a
/// fan of triangles about the average of its vertices, OpenFOAM's decomposition; who shares the face shares the
/// triangles, so that nothing is lost or counted twice between cells.
class Facets
{
public:
    void clear();

    /// Add a face, a simple polygon of n >= 3 vertices.  Facets without area are left out.  Vertices of the facets
    /// are appended to loops if it is given.
    void addFace(const Point3* vertices, std::size_t n, std::vector<Point3>* loops = nullptr);

    /// Add a loop in the plane of another facet as a face of its own.
    void addLoop(const Facet& frame, const Point3* vertices, std::size_t n);

    /// Add a loop in the plane with the given unit normal through the point.
    void addLoop(const Point3& normal, const Point3& point, const Point3* vertices, std::size_t n);

    std::size_t nFaces() const { return faceStart_.size() - 1; }
    const Facet* begin(std::size_t face) const { return facets_.data() + faceStart_[face]; }
    const Facet* end(std::size_t face) const { return facets_.data() + faceStart_[face + 1]; }
    std::size_t nVertices(const Facet& facet) const { return facet.end - facet.begin; }

    /// Vertices in the facet's frame [m].
    const Point2* vertices(const Facet& facet) const { return vertices_.data() + facet.begin; }

    /// [m^2]
    double area(const Facet& facet) const;

    /// [m^2]
    double faceArea(std::size_t face) const;

private:
    void addFacet(const Facet& frame, const Point3* vertices, std::size_t n);

    std::vector<Facet> facets_;
    std::vector<Point2> vertices_;
    std::vector<std::uint32_t> faceStart_{0};
};

}  // namespace overlap
