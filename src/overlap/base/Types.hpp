// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <cmath>

/// Exact intersections of grains with mesh cells: pure geometry, no bodies, no OpenFOAM.
///
/// Disc and polygon: DiscPolygon.hpp.  Ball and polyhedron: BallPolyhedron.hpp.  Ball and all cells of a mesh:
/// PolyhedralMesh.hpp, BallMesh.hpp.  Clusters of discs or balls: PowerCell.hpp, with Clip.hpp for a cell by itself.
/// Lengths are in any unit, areas and volumes in its square and cube; [m] below stands for it.  Nothing traps: the
/// functions raise no floating-point exception but underflow and inexact.
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
