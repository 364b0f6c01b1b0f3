// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <cmath>

/// Exact intersections of grains with mesh cells: pure geometry, no bodies, no OpenFOAM.
namespace overlap
{

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

inline double cross(const Point2& a, const Point2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

inline bool isFinite(const Point3& x)
{
    return std::isfinite(x.x()) && std::isfinite(x.y()) && std::isfinite(x.z());
}

}  // namespace overlap
