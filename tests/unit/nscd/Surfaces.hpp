// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Random.hpp"
#include "nscd/walls/Walls.hpp"

#include <map>

/// Surfaces of triangles for tests.
using Point = nscd::Vector<3>;
using Surface = nscd::Walls<3>;

inline void addTriangle(Surface& surface, const Point& a, const Point& b, const Point& c)
{
    surface.push_back(nscd::Triangle{a, b, c, 1});
}

/// A parallelogram of n x n pieces; the diagonals, and where each triangle begins, are chosen at random.
inline void addParallelogram(Surface& surface, const Point& corner, const Point& along, const Point& across, int n = 1,
                             std::uint64_t seed = 1)
{
    nscd::Random random(seed);
    const auto add = [&](Point a, Point b, Point c)
    {
        for (int turns = static_cast<int>(random.uniform(0, 3)); turns > 0; --turns)
        {
            std::swap(a, b);
            std::swap(b, c);
        }
        addTriangle(surface, a, b, c);
    };
    const auto point = [&](int i, int j) -> Point { return corner + along * i / n + across * j / n; };
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            const Point a = point(i, j);
            const Point b = point(i + 1, j);
            const Point c = point(i + 1, j + 1);
            const Point d = point(i, j + 1);
            if (random.uniform(0, 1) < 0.5)
            {
                add(a, b, c);
                add(a, c, d);
            }
            else
            {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
}

/// The surface of the box from the origin to 'size', n x n pieces on each side.
inline Surface boxSurface(const Point& size, int n = 1)
{
    Surface surface;
    for (int axis = 0; axis < 3; ++axis)
    {
        Point edge[3];
        for (int k = 0; k < 3; ++k)
        {
            edge[k] = size[(axis + k) % 3] * Point::Unit((axis + k) % 3);
        }
        addParallelogram(surface, Point::Zero(), edge[2], edge[1], n, axis + 1);
        addParallelogram(surface, edge[0], edge[1], edge[2], n, axis + 4);
    }
    return surface;
}

/// A sphere around the origin: an icosahedron whose triangles are cut in four, 'cuts' times.
inline Surface sphereSurface(double radius, int cuts)
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Point> corners;
    for (int axis = 0; axis < 3; ++axis)
    {
        for (int k = 0; k < 4; ++k)
        {
            Point x = Point::Zero();
            x[axis] = k & 1 ? 1 : -1;
            x[(axis + 1) % 3] = k & 2 ? golden : -golden;
            corners.push_back(x.normalized());
        }
    }
    std::vector<std::array<Point, 3>> triangles;
    const double edge = 2 / std::sqrt(1 + golden * golden);
    for (std::size_t a = 0; a < 12; ++a)
    {
        for (std::size_t b = a + 1; b < 12; ++b)
        {
            for (std::size_t c = b + 1; c < 12; ++c)
            {
                const double longest = std::max({(corners[a] - corners[b]).norm(), (corners[b] - corners[c]).norm(),
                                                 (corners[c] - corners[a]).norm()});
                if (longest < 1.01 * edge)
                {
                    triangles.push_back({corners[a], corners[b], corners[c]});
                }
            }
        }
    }
    for (int cut = 0; cut < cuts; ++cut)
    {
        std::vector<std::array<Point, 3>> finer;
        for (const auto& [a, b, c] : triangles)
        {
            const Point ab = (a + b).normalized();
            const Point bc = (b + c).normalized();
            const Point ca = (c + a).normalized();
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    Surface surface;
    for (const auto& [a, b, c] : triangles)
    {
        addTriangle(surface, radius * a, radius * b, radius * c);
    }
    return surface;
}

/// A closed surface around the origin, of sphereSurface's triangles, with hills, hollows and saddles.
inline Surface bumpySurface(double radius, int cuts)
{
    Surface surface = sphereSurface(1, cuts);
    const auto displaced = [radius](const Point& x) -> Point
    { return radius * x * (1 + 0.25 * std::sin(6 * x.x()) * std::cos(8 * x.y() + 2 * x.z())); };
    for (auto& wall : surface)
    {
        auto& triangle = std::get<nscd::Triangle>(wall);
        triangle.a = displaced(triangle.a);
        triangle.b = displaced(triangle.b);
        triangle.c = displaced(triangle.c);
    }
    return surface;
}

/// Does a point lie inside a closed surface around the origin?  By the solid angle that the surface covers: 4 pi or 0
/// (Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30, 125, 1983, doi:10.1109/TBME.1983.325207).
inline bool isInside(const Surface& surface, const Point& x)
{
    double angle = 0;
    for (const auto& wall : surface)
    {
        const auto& triangle = std::get<nscd::Triangle>(wall);
        const Point a = triangle.a - x;
        const Point b = triangle.b - x;
        const Point c = triangle.c - x;
        const double volume = a.dot(b.cross(c));
        const double part = 2 * std::atan2(volume, a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                       b.dot(c) * a.norm() + c.dot(a) * b.norm());
        const bool outward = (triangle.b - triangle.a).cross(triangle.c - triangle.a).dot(triangle.a) > 0;
        angle += outward ? part : -part;
    }
    return angle > 2 * M_PI;
}

/// Least value of a convex function between two arguments.
template <class F>
double leastValue(double lower, double upper, F&& f)
{
    for (int i = 0; i < 80; ++i)
    {
        const double left = (2 * lower + upper) / 3;
        const double right = (lower + 2 * upper) / 3;
        (f(left) < f(right) ? upper : lower) = f(left) < f(right) ? right : left;
    }
    return f((lower + upper) / 2);
}

/// Distance of a point to a triangle [m], by search: it is a convex function of the place on the triangle.
inline double searchedDistance(const nscd::Triangle& triangle, const Point& x)
{
    return leastValue(0, 1,
                      [&](double s)
                      {
                          const Point onSide = triangle.a + s * (triangle.b - triangle.a) - x;
                          const Point across = triangle.c - triangle.a;
                          return leastValue(0, 1 - s, [&](double t) { return (onSide + t * across).norm(); });
                      });
}
