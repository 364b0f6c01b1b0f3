// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shapes.hpp"

#include <gtest/gtest.h>
#include <random>
#include <string>

using namespace overlap;

namespace partitionOfUnity
{

struct Mesh
{
    std::string kind;
    std::vector<Polygon> cells;
};

/// n x n squares of unit size about the origin, rotated, their vertices moved by up to `warp`, split into triangles.
Mesh makeMesh(const std::string& kind, int n, const Point2& origin)
{
    const double warp = kind.find("warped") != std::string::npos ? 0.2 : 0.0;
    const double angle = kind.find("rotated") != std::string::npos ? 0.3 : 0.0;
    const bool triangles = kind.find("triangles") != std::string::npos;

    std::mt19937 random(7);
    std::uniform_real_distribution<double> move(-warp, warp);

    std::vector<Point2> points;
    for (int j = 0; j <= n; ++j)
    {
        for (int i = 0; i <= n; ++i)
        {
            const Point2 p(i - n / 2 + move(random), j - n / 2 + move(random));
            points.push_back(rotated(p, angle) + origin);
        }
    }

    Mesh mesh{kind, {}};
    for (int j = 0; j < n; ++j)
    {
        for (int i = 0; i < n; ++i)
        {
            const int k = i + (n + 1) * j;
            const Point2 a = points[k], b = points[k + 1], c = points[k + n + 2], d = points[k + n + 1];
            if (triangles)
            {
                mesh.cells.push_back({a, b, c});
                mesh.cells.push_back({a, c, d});
            }
            else
            {
                mesh.cells.push_back({a, b, c, d});
            }
        }
    }
    return mesh;
}

/// Worst of |sum of areas - pi r^2|/(pi r^2) and |sum of moments|/(pi r^3).
double partitionError(const Mesh& mesh, const Point2& centre, double radius)
{
    double area = 0;
    Point2 moment = Point2::Zero();
    for (const Polygon& cell : mesh.cells)
    {
        const AreaMoment a = discPolygon(centre, radius, cell);
        area += a.area;
        moment += a.area * (a.centroid - centre);
    }
    const double whole = pi * radius * radius;
    return std::max(std::abs(area / whole - 1), moment.norm() / (whole * radius));
}

const std::string kinds[] = {"squares",           "rotated squares",  "warped squares",          "triangles",
                             "rotated triangles", "warped triangles", "warped rotated triangles"};

/// Radii in units of the cell's size for h/d from 1/30 to 30.
const double radii[] = {15, 5, 1.5, 0.5, 1. / 6, 1. / 20, 1. / 60};

TEST(PartitionOfUnity, HoldsInGeneralPosition)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-0.5, 0.5);
    for (const std::string& kind : kinds)
    {
        for (double r : radii)
        {
            const Mesh mesh = makeMesh(kind, 2 * static_cast<int>(r + 3), {0, 0});
            for (int k = 0; k < 40; ++k)
            {
                const Point2 centre(place(random), place(random));
                EXPECT_LE(partitionError(mesh, centre, r), 1e-14) << kind << ", radius " << r;
            }
        }
    }
}

TEST(PartitionOfUnity, HoldsWhereVerticesAndEdgesMeetCentreAndCircle)
{
    for (const std::string& kind : kinds)
    {
        for (double r : radii)
        {
            const int n = 2 * static_cast<int>(2 * r + 4);
            const Mesh mesh = makeMesh(kind, n, {0, 0});
            const Polygon& cell = mesh.cells[mesh.cells.size() / 2 + mesh.cells.size() / n / 2];
            const Point2 vertex = cell[0], edge = cell[1] - cell[0];
            const Point2 normal = Point2(-edge.y(), edge.x()).normalized();
            const Point2 along = edge.normalized();
            const Point2 places[] = {vertex,               // centre on a vertex
                                     vertex + 0.5 * edge,  // centre on an edge
                                     vertex + 0.25 * edge,
                                     vertex + 0.5 * edge + r * normal,  // circle touches an edge
                                     vertex + 0.5 * edge - r * normal,
                                     vertex + r * normal,  // circle touches at a vertex
                                     vertex + r * along,   // circle through a vertex
                                     vertex + 0.6 * r * along + 0.8 * r * normal,
                                     polygon(cell).centroid};
            for (const Point2& place : places)
            {
                for (double e : {0.0, 1e-12, -1e-12, 1e-16, -1e-16})
                {
                    for (const Point2& shift : {Point2(e, 0), Point2(0, e), Point2(e, e)})
                    {
                        EXPECT_LE(partitionError(mesh, place + shift, r), 1e-14) << kind << ", radius " << r;
                    }
                }
            }
        }
    }
}

TEST(PartitionOfUnity, HoldsFarFromTheOrigin)
{
    const Point2 origin(100, -70);
    for (const std::string& kind : kinds)
    {
        for (double r : radii)
        {
            const Mesh mesh = makeMesh(kind, 2 * static_cast<int>(r + 3), origin);
            double area = 0;
            for (const Polygon& cell : mesh.cells) area += discPolygon(origin + Point2(0.1, 0.2), r, cell).area;
            EXPECT_NEAR(area / (pi * r * r), 1, 1e-14) << kind << ", radius " << r;
        }
    }
}

}  // namespace partitionOfUnity
