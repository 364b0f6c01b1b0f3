// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/Types.hpp"

#include <optional>
#include <vector>

namespace overlap
{

/// Points x with normal . (x - point) <= 0.
template <int D>
struct HalfSpace
{
    using Point = Eigen::Matrix<double, D, 1>;
    Point normal;  ///< of unit length
    Point point;   ///< on the boundary [m]

    double distance(const Point& x) const { return normal.dot(x - point); }
};

/// Disc (D = 2) or ball (D = 3).
template <int D>
struct Sphere
{
    Eigen::Matrix<double, D, 1> centre;  ///< [m]
    double radius;                       ///< > 0 [m]
};

/// The part of a union of discs or balls that is member i's own: within its power cell, the points whose power
/// |x - centre|^2 - radius^2 is smaller than with respect to any other member.  A point of the union is in the member
/// of smallest power, so that the members' parts fill the union and do not overlap; what is cut off by a boundary
/// between two power cells is the plane of the circle in which their spheres meet (doc/theory, eq. 1.8).
///
/// Returns the half-spaces that cut the member, or nothing if no part of it is its own.  Of equal members the first
/// counts.
template <int D>
std::optional<std::vector<HalfSpace<D>>> powerCell(const std::vector<Sphere<D>>& members, std::size_t i);

}  // namespace overlap
