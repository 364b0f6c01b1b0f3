// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/mesh/Facets.hpp"

namespace overlap
{

/// A face of a cell and the side on which the cell lies.
struct CellFace
{
    std::uint32_t face;
    double sign;  ///< 1 if the face's normal leaves the cell, -1 if it enters it
};

/// What is known of a cell without a ball.
struct CellShape
{
    Point3 low, high;  ///< bounds [m]
    Point3 centroid;   ///< [m]
    double volume;     ///< [m^3], negative if the faces look inwards
    double dent;       ///< farthest that a vertex lies in front of a facet's plane [m]; 0 below 1e-12 of its size

    bool convex() const { return dent == 0; }
};

/// A cell of a polyhedron or mesh.
struct CellView
{
    const Facets& facets;
    const CellShape& shape;
    const CellFace* faces;
    std::size_t nFaces;
};

/// Volume and centroid are those of the polyhedron that the facets bound, by the divergence theorem about the mean of
/// the vertices.
CellShape cellShape(const Facets& facets, const CellFace* faces, std::size_t nFaces, const Point3* vertices,
                    std::size_t nVertices);

/// Norm of the sum of the faces' area vectors over the sum of their areas: zero if the cell is closed.
double gap(const Facets& facets, const CellFace* faces, std::size_t nFaces);

}  // namespace overlap
