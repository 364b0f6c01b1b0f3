// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <array>

namespace nscd
{

/// The corners of a segment (D = 2) or of a triangle (D = 3).
template <int D>
using Facet = std::array<Vector<D>, D>;

/// A segment's end (edge: -1), or a triangle's corner and the edge from there to its next corner.
struct FacetSide
{
    int corner, edge;
};

/// Corners that coincide and edges that are shared, of facets that move together.
///
/// Corners nearer to each other than 1e-9 times the largest extent of all facets are one.  Where a corner lies on
/// the free edge of a triangle, to the same tolerance, the edge is cut there: the triangle has a fourth side, and the
/// two parts of its edge are shared with the triangles beyond like any other edge.
template <int D>
struct WallJoints
{
    WallJoints() = default;
    WallJoints(const std::vector<Facet<D>>& facets, const std::vector<int>& bodies);

    Vectors<D> corner;                       ///< position
    std::vector<int> body;                   ///< of each corner
    std::vector<std::array<int, 2>> edge;    ///< its corners, the lower number first
    std::vector<std::size_t> sideBegin;      ///< of each facet, and the end
    std::vector<FacetSide> side;

    /// Joints are the corners and, counted after them, the edges; the facets at each, in the order of their numbers.
    std::vector<std::size_t> facetBegin;
    std::vector<int> facet;

    int jointOf(int edgeNumber) const { return static_cast<int>(corner.size()) + edgeNumber; }

private:
    void cutSides(const std::vector<std::array<int, D>>& corners, double same);
    void collectFacets();
};

}  // namespace nscd
