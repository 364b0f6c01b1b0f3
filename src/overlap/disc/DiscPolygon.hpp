// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/Types.hpp"

#include <cstddef>

namespace overlap
{

/// Area [m^2] and centroid [m] of an intersection; the centroid of an empty one is the disc's centre.
struct AreaMoment
{
    double area = 0;
    Point2 centroid = Point2::Zero();
};

/// Exact intersection of a disc (radius > 0) with a simple polygon of n >= 3 vertices in counter-clockwise order.
/// The polygon need not be convex.  Absolute error of the area about 1e-15 pi radius^2, of a sliver's area less than
/// 20 times what rounding of its coordinates does; areas over the cells of a mesh add up to the disc's.  Divergence
/// theorem over the chords of the polygon's edges and the arcs between them (doc/theory, eq. 1.2, 1.3 and 1.12).
AreaMoment discPolygon(const Point2& centre, double radius, const Point2* vertices, std::size_t n);

/// Signed area [m^2] and centroid [m] of a simple polygon (positive if counter-clockwise).
AreaMoment polygon(const Point2* vertices, std::size_t n);

}  // namespace overlap
