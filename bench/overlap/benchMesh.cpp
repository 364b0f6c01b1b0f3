// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Balls in a mesh of cubes, of hexahedra with warped faces and of tetrahedra: time per ball and per cell overlapped,
// with the cell that held the whole ball before as a hint, and the share of the search.

#include "../../tests/unit/overlap/Meshes.hpp"
#include "bestOf.hpp"
#include "overlap/ball/BallMesh.hpp"

#include <cstdio>

using namespace overlap;

constexpr int passes = 5;

int main()
{
    const int n = 40;
    std::printf("%-20s %8s %12s %12s %15s %12s %8s\n", "mesh", "h/d", "us per ball", "with hint", "cells per ball",
                "ns per cell", "search");
    for (const std::string kind : {"rotated", "warped", "rotated tetrahedra"})
    {
        const PolyhedralMesh mesh = blockOfKind(kind, n, {0, 0, 0}).mesh();
        BallMesh ball(mesh);
        for (const double h : {1. / 30, 0.1, 1. / 3, 1., 3., 10., 30.})
        {
            const double r = 0.5 / h, free = n / 2 - r - 1;
            const int nBalls = h < 0.05 ? 4 : h < 0.3 ? 40 : 2000;
            std::mt19937 random(9);
            std::uniform_real_distribution<double> unit(-0.5, 0.5);
            std::vector<Point3> centres;
            for (int k = 0; k < nBalls; ++k) centres.push_back(free * Point3(unit(random), unit(random), unit(random)));

            double cells = 0, sum = 0;
            std::vector<int> last;
            const double all = bestOf(
                passes,
                [&]
                {
                    cells = 0;
                    for (const Point3& c : centres) cells += static_cast<double>(ball.overlaps(c, r).size());
                });
            for (const Point3& c : centres)
            {
                const std::vector<CellOverlap>& parts = ball.overlaps(c, r);
                last.push_back(parts.size() == 1 ? parts[0].cell : -1);
            }
            const double hinted = bestOf(
                passes,
                [&]
                {
                    for (std::size_t k = 0; k < centres.size(); ++k) ball.overlaps(centres[k], r, last[k]);
                });
            const double search = bestOf(
                passes,
                [&]
                {
                    const auto count = [&](int c)
                    {
                        sum += c;
                        return true;
                    };
                    for (const Point3& c : centres) mesh.tree().forCells(c, r, count, count);
                });
            std::printf("%-20s %8.4f %12.2f %12.2f %15.1f %12.0f %7.1f%%\n", kind.c_str(), h, 1e6 * all / nBalls,
                        1e6 * hinted / nBalls, cells / nBalls, 1e9 * all / cells, sum > 0 ? 100 * search / all : 0);
        }
    }
}
