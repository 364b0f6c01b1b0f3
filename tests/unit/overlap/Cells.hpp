// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallPolyhedron.hpp"

#include <Eigen/Geometry>
#include <random>
#include <vector>

namespace overlap
{

using Faces = std::vector<std::vector<int>>;

/// Vertices and faces; hexahedra in OpenFOAM's order of vertices.
struct Cell
{
    std::vector<Point3> vertices;
    Faces faces;
};

inline const Faces hexFaces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
inline const Faces tetFaces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

inline Cell box(const Point3& a, const Point3& b)
{
    return {{{a.x(), a.y(), a.z()},
             {b.x(), a.y(), a.z()},
             {b.x(), b.y(), a.z()},
             {a.x(), b.y(), a.z()},
             {a.x(), a.y(), b.z()},
             {b.x(), a.y(), b.z()},
             {b.x(), b.y(), b.z()},
             {a.x(), b.y(), b.z()}},
            hexFaces};
}

/// Ordered so that its volume is positive.
inline Cell tetrahedron(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
    const bool right = (b - a).cross(c - a).dot(d - a) > 0;
    return {{a, right ? b : c, right ? c : b, d}, tetFaces};
}

/// The squares (0, 0)-(2, 1) and (0, 1)-(1, 2) over 0 < z < 1.
inline Cell extrudedL()
{
    Cell cell{{}, {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}}};
    const double corners[][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const double z : {0., 1.})
    {
        for (const auto& p : corners) cell.vertices.emplace_back(p[0], p[1], z);
    }
    for (int k = 0; k < 6; ++k) cell.faces.push_back({k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6});
    return cell;
}

inline BallOverlap ballCell(const Point3& centre, double radius, const Cell& cell)
{
    return ballPolyhedron(centre, radius, Polyhedron(cell.vertices, cell.faces));
}

inline BallOverlap unitBallIn(const Cell& cell)
{
    return ballCell(Point3::Zero(), 1, cell);
}

template <class Map>
Cell mapped(Cell cell, Map map)
{
    for (Point3& v : cell.vertices) v = map(v);
    return cell;
}

inline Eigen::Matrix3d randomRotation(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    return q.normalized().toRotationMatrix();
}

}  // namespace overlap
