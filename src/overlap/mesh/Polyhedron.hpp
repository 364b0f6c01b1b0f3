// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/mesh/CellShape.hpp"

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

    /// Of facets that close and may bound nothing.  Vertices of the facets follow each other in loops.
    Polyhedron(Facets facets, std::vector<Point3> loops);

    double volume() const { return shape_.volume; }             ///< [m^3]
    const Point3& centroid() const { return shape_.centroid; }  ///< [m]
    std::size_t nFaces() const { return faces_.size(); }

    CellView view() const { return {facets_, shape_, faces_.data(), faces_.size()}; }
    const std::vector<Point3>& vertices() const { return loops_; }  ///< of all facets [m]

    /// f(facet, vertices, number of vertices) for all facets.
    template <class F>
    void forLoops(F&& f) const;

private:
    void prepare();

    Facets facets_;
    std::vector<Point3> loops_;
    std::vector<CellFace> faces_;
    CellShape shape_{Point3::Zero(), Point3::Zero(), Point3::Zero(), 0, true};
};

template <class F>
void Polyhedron::forLoops(F&& f) const
{
    for (std::size_t face = 0; face < facets_.nFaces(); ++face)
    {
        for (const Facet* facet = facets_.begin(face); facet != facets_.end(face); ++facet)
        {
            f(*facet, loops_.data() + facet->begin, facets_.nVertices(*facet));
        }
    }
}

}  // namespace overlap
