// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Overlaps much smaller than disc and cell, against signed triangles in quadruple precision.

#include "BallOracle.hpp"
#include "Shapes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace overlap;
using oracle::Quad;

namespace discSlivers
{

struct Sum
{
    Quad area = 0, x = 0, y = 0;  ///< area and first moment
    Quad boundary = 0;            ///< length of the chords
};

/// The unit disc within the triangle (centre, p, q), signed: at most three pieces, sectors and triangles.
void addTriangle(Sum& sum, Quad px, Quad py, Quad qx, Quad qy)
{
    const auto sector = [&](Quad ax, Quad ay, Quad bx, Quad by)
    {
        const Quad a = sqrtq(ax * ax + ay * ay), b = sqrtq(bx * bx + by * by);
        sum.area += atan2q(ax * by - ay * bx, ax * bx + ay * by) / 2;
        sum.x += (by / b - ay / a) / 3;
        sum.y += (ax / a - bx / b) / 3;
    };
    const Quad dx = qx - px, dy = qy - py;
    const Quad a = dx * dx + dy * dy, b = px * dx + py * dy, c = px * px + py * py - 1, discriminant = b * b - a * c;
    if (discriminant <= 0) return sector(px, py, qx, qy);

    const Quad root = sqrtq(discriminant);
    const auto unit = [](Quad t) { return t < 0 ? Quad(0) : t > 1 ? Quad(1) : t; };
    const Quad t0 = unit((-b - root) / a), t1 = unit((-b + root) / a);
    const Quad x0 = px + t0 * dx, y0 = py + t0 * dy, x1 = px + t1 * dx, y1 = py + t1 * dy;
    if (t0 > 0) sector(px, py, x0, y0);
    if (t1 > t0)
    {
        const Quad cross = x0 * y1 - y0 * x1;
        sum.area += cross / 2;
        sum.x += cross / 6 * (x0 + x1);
        sum.y += cross / 6 * (y0 + y1);
        sum.boundary += (t1 - t0) * sqrtq(a);
    }
    if (t1 < 1) sector(x1, y1, qx, qy);
}

Sum exact(const Point2& centre, const Polygon& cell)
{
    Sum sum;
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
        const Point2 &p = cell[k], &q = cell[(k + 1) % cell.size()];
        addTriangle(sum, Quad(p.x()) - Quad(centre.x()), Quad(p.y()) - Quad(centre.y()),
                    Quad(q.x()) - Quad(centre.x()), Quad(q.y()) - Quad(centre.y()));
    }
    return sum;
}

struct Errors
{
    double area = 0, centroid = 0;  ///< in units of kappa eps
    int count = 0;

    /// kappa: relative change of the area per shift of every bounding curve by eps times the largest distance from
    /// the disc's centre, which is what rounding the coordinates can do.
    void compare(const Point2& centre, const Polygon& cell)
    {
        const Sum truth = exact(centre, cell);
        const double whole = static_cast<double>(truth.area);
        if (!(whole > 0 && truth.boundary > 0)) return;
        double reach = 1;
        for (const Point2& v : cell) reach = std::max(reach, (v - centre).norm());
        // The arc is no longer than the chords, for these cells
        const double kappa = 2 * reach * static_cast<double>(truth.boundary) / whole;
        const double unit = kappa * std::numeric_limits<double>::epsilon();
        if (unit > 0.01) return;

        ++count;
        const AreaMoment x = discPolygon(centre, 1, cell);
        area = std::max(area, std::abs(static_cast<double>(Quad(x.area) - truth.area)) / (whole * unit));
        const Point2 arm(static_cast<double>(truth.x / truth.area), static_cast<double>(truth.y / truth.area));
        centroid = std::max(centroid, (x.centroid - centre - arm).norm() / unit);
    }
};

TEST(DiscSlivers, CornersAndEdgesThatDipIntoTheDiscKeepTheirRelativeAccuracy)
{
    std::mt19937 random(41);
    std::uniform_real_distribution<double> unit(0, 1);
    Errors errors;
    for (int pair = 0; pair < 2000; ++pair)
    {
        const double size = std::pow(10, 2 * unit(random) - 1), turn = 2 * pi * unit(random);
        Polygon cell = pair % 2 ? Polygon{{0, 0}, {1, 0.2}, {0.3, 1}}
                                : Polygon{{0, 0}, {1, 0}, {1, 0.3 + unit(random)}, {0.1, 0.3 + unit(random)}};
        for (Point2& v : cell) v = rotated(size * v, turn);

        Point2 place = cell[0], middle = Point2::Zero();
        for (const Point2& v : cell) middle += v / static_cast<double>(cell.size());
        Point2 outward = place - middle;
        if (pair % 3)
        {
            const Point2 d = cell[1] - cell[0];
            place += (0.3 + 0.4 * unit(random)) * d;
            outward -= outward.dot(d) / d.squaredNorm() * d;
        }
        const double depth = std::pow(10, -7 * unit(random) - 1);
        errors.compare(place + (1 - depth) * outward.normalized(), cell);
    }
    EXPECT_LT(errors.area, 20);
    EXPECT_LT(errors.centroid, 20);
    EXPECT_GT(errors.count, 1800);
}

TEST(DiscSlivers, SmallCellsAtTheCircleKeepTheirRelativeAccuracy)
{
    std::mt19937 random(42);
    std::uniform_real_distribution<double> unit(-1, 1);
    Errors errors;
    for (int pair = 0; pair < 2000; ++pair)
    {
        const double size = std::pow(10, -2.5 + 2 * unit(random)), turn = pi * unit(random);
        const Point2 a = rotated({1, 0}, pi * unit(random));
        const Point2 shift = 0.5 * size * Point2(unit(random), unit(random));
        Polygon cell{{-0.5, -0.5}, {0.6, -0.4}, {0.5, 0.5}, {-0.4, 0.6}};
        for (Point2& v : cell) v = a + shift + rotated(size * v, turn);
        errors.compare(Point2::Zero(), cell);
    }
    EXPECT_LT(errors.area, 20);
    EXPECT_LT(errors.centroid, 20);
    EXPECT_GT(errors.count, 1000);
}

}  // namespace discSlivers
