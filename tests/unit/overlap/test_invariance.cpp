// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shapes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace overlap;

namespace
{

const Polygon cells[] = {
    {{-0.2, -0.4}, {1.3, -0.6}, {0.9, 0.8}, {-0.5, 0.7}},
    {{0.2, 0.1}, {2.0, 0.4}, {0.3, 1.4}},
    {{-2, -0.3}, {2, -0.2}, {2, 0.3}, {0.1, 0.0}, {-2, 0.2}},
};

template <typename Map>
Polygon mapped(Polygon cell, Map map)
{
    std::transform(cell.begin(), cell.end(), cell.begin(), map);
    return cell;
}

}  // namespace

TEST(Invariance, FirstVertexDoesNotMatter)
{
    for (Polygon cell : cells)
    {
        const AreaMoment a = unitDisc(cell);
        for (std::size_t k = 0; k < cell.size(); ++k)
        {
            std::rotate(cell.begin(), cell.begin() + 1, cell.end());
            const AreaMoment b = unitDisc(cell);
            EXPECT_NEAR(b.area, a.area, 1e-15);
            EXPECT_LT((b.centroid - a.centroid).norm(), 2e-15);
        }
    }
}

TEST(Invariance, ScalingByAPowerOfTwoIsExact)
{
    for (const Polygon& cell : cells)
    {
        const AreaMoment a = unitDisc(cell);
        for (double s : {0x1p-20, 0x1p-3, 0x1p17})
        {
            const AreaMoment b = discPolygon({0, 0}, s, mapped(cell, [&](const Point2& p) -> Point2 { return s * p; }));
            EXPECT_EQ(b.area, a.area * s * s);
            EXPECT_EQ(b.centroid, a.centroid * s);
        }
    }
}

TEST(Invariance, TranslationMovesTheCentroid)
{
    for (const Polygon& cell : cells)
    {
        const AreaMoment a = unitDisc(cell);
        for (const Point2& t : {Point2(0.7, -3.1), Point2(100.3, 57.7)})
        {
            const AreaMoment b = discPolygon(t, 1, mapped(cell, [&](const Point2& p) -> Point2 { return p + t; }));
            const double rounding = 4e-16 * t.norm();
            EXPECT_NEAR(b.area, a.area, 4 * rounding);
            EXPECT_LT((b.centroid - a.centroid - t).norm(), 10 * rounding);
        }
    }
}

TEST(Invariance, RotationTurnsTheCentroid)
{
    for (const Polygon& cell : cells)
    {
        const AreaMoment a = unitDisc(cell);
        for (int k = 1; k < 40; ++k)
        {
            const double angle = 0.37 * k;
            const AreaMoment b = unitDisc(mapped(cell, [&](const Point2& p) { return rotated(p, angle); }));
            EXPECT_NEAR(b.area, a.area, 3e-15);
            EXPECT_LT((b.centroid - rotated(a.centroid, angle)).norm(), 5e-15);
        }
    }
}

TEST(Invariance, ReflectionInTheCellOrderIsTheSameArea)
{
    for (const Polygon& cell : cells)
    {
        Polygon mirrored = mapped(cell, [](const Point2& p) { return Point2(-p.x(), p.y()); });
        std::reverse(mirrored.begin(), mirrored.end());
        const AreaMoment a = unitDisc(cell), b = unitDisc(mirrored);
        EXPECT_NEAR(b.area, a.area, 1e-15);
        EXPECT_NEAR(b.centroid.x(), -a.centroid.x(), 2e-15);
    }
}
