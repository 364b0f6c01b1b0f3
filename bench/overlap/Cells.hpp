// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/mesh/Polyhedron.hpp"

#include <Eigen/Geometry>
#include <functional>
#include <random>
#include <vector>

/// Cells of about unit volume about the origin.
struct CellKind
{
    const char* name;
    double reach;  ///< no vertex is farther from the origin
    std::vector<std::vector<int>> faces;
    std::function<std::vector<overlap::Point3>(std::mt19937&)> vertices;
};

inline std::vector<CellKind> cellKinds()
{
    using overlap::Point3;
    const std::vector<std::vector<int>> hex = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const std::vector<std::vector<int>> tet = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const std::vector<Point3> cube = {{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {0.5, 0.5, -0.5}, {-0.5, 0.5, -0.5},
                                      {-0.5, -0.5, 0.5},  {0.5, -0.5, 0.5},  {0.5, 0.5, 0.5},  {-0.5, 0.5, 0.5}};

    const auto mapped = [](std::vector<Point3> vertices, const Eigen::Matrix3d& map)
    {
        for (Point3& v : vertices) v = map * v;
        return vertices;
    };
    const auto turned = [](std::mt19937& random) -> Eigen::Matrix3d
    {
        std::normal_distribution<double> normal;
        const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
        return q.normalized().toRotationMatrix();
    };
    const auto tetrahedron = [](std::mt19937& random)
    {
        std::uniform_real_distribution<double> unit(-1, 1);
        std::vector<Point3> v(4);
        double volume = 0;
        while (volume < 0.3)
        {
            for (Point3& x : v) x = 1.2 * Point3(unit(random), unit(random), unit(random));
            volume = (v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0]) / 6;
        }
        return v;
    };

    Eigen::Matrix3d shear, needle;
    shear << 1, 0.3, 0.2, 0, 1, 0.4, 0, 0, 1;
    needle = Eigen::Vector3d(0.2714, 0.2714, 13.57).asDiagonal();
    return {{"cube", 0.87, hex, [=](std::mt19937&) { return cube; }},
            {"sheared hexahedron", 1.2, hex, [=](std::mt19937& r) { return mapped(cube, turned(r) * shear); }},
            {"tetrahedron", 2.1, tet, tetrahedron},
            {"needle 1:50", 6.8, hex, [=](std::mt19937& r) { return mapped(cube, turned(r) * needle); }}};
}
