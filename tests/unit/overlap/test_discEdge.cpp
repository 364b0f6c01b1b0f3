// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shapes.hpp"
#include "overlap/disc/DiscEdge.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace overlap;

TEST(DiscEdge, HasTheLengthOfAChord)
{
    const Point2 centre(3, -1);
    for (const double h : {0.0, 0.3, 0.99})
    {
        const double half = 2 * std::sqrt(1 - h * h);
        const double x = 3 + 2 * h;
        EXPECT_NEAR(edgeInDisc(centre, 2, {x, -9}, {x, 5}).length, 2 * half, 1e-14);
        EXPECT_NEAR(edgeInDisc(centre, 2, {x, -1}, {x, 5}).length, half, 1e-14);
        EXPECT_NEAR(edgeInDisc(centre, 2, {x, -1}, {x, -1 + 0.1 * half}).length, 0.1 * half, 1e-14);
    }
    EXPECT_EQ(edgeInDisc(centre, 2, {5.5, -9}, {5.5, 5}).length, 0);
    EXPECT_EQ(edgeInDisc(centre, 2, {3, 2}, {3, 5}).length, 0);
}

TEST(DiscEdge, HasTheMiddleOfAChord)
{
    const Point2 centre(3, -1);
    const double half = 2 * std::sqrt(1 - 0.3 * 0.3);
    EXPECT_NEAR((edgeInDisc(centre, 2, {3.6, -9}, {3.6, 5}).middle - Point2(3.6, -1)).norm(), 0, 1e-14);
    EXPECT_NEAR((edgeInDisc(centre, 2, {3.6, -1}, {3.6, 5}).middle - Point2(3.6, -1 + half / 2)).norm(), 0, 1e-14);
    EXPECT_EQ(edgeInDisc(centre, 2, {3, 2}, {3, 5}).middle, centre);
}

TEST(DiscEdge, IsTheSameFromBothEnds)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> in(-2, 2);
    for (int i = 0; i < 10000; ++i)
    {
        const Point2 centre(in(random), in(random)), p(in(random), in(random)), q(in(random), in(random));
        EXPECT_EQ(edgeInDisc(centre, 1.3, p, q).length, edgeInDisc(centre, 1.3, q, p).length);
    }
}

/// Divergence theorem: open parts of the edges times normals, and the surface of the disc within the cell, close.  The
/// latter is here that of the arc between the points where the circle leaves the cell, from the areas' derivative.
TEST(DiscEdge, ClosesTheFluidOfACell)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> in(-1, 1), angle(0, 2 * pi);
    int cut = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const double turn = angle(random), h = 0.3;
        const Point2 middle(in(random), in(random)), centre(0.1, -0.2);
        Polygon cell = rectangle(-0.5 * h, -0.5 * h, 0.5 * h, 0.5 * h);
        for (Point2& x : cell) x = middle + rotated(x, turn);

        Point2 closed = Point2::Zero();
        for (std::size_t k = 0; k < 4; ++k)
        {
            const Point2 p = cell[k], d = cell[(k + 1) % 4] - p;
            const Point2 normal = Point2(d.y(), -d.x()) / d.norm();
            closed += edgeInDisc(centre, 0.8, p, p + d).length * normal;
        }

        // Area gained when the disc moves by a small step: minus the wall vector times the step
        const double step = 1e-5;
        for (int axis = 0; axis < 2; ++axis)
        {
            Point2 way = Point2::Zero();
            way[axis] = step;
            const double gain = discPolygon(Point2(centre + way), 0.8, cell).area
                                - discPolygon(Point2(centre - way), 0.8, cell).area;
            EXPECT_NEAR(gain / (2 * step), -closed[axis], 1e-6);
        }
        cut += closed.norm() > 1e-3;
    }
    EXPECT_GT(cut, 300);
}
