// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shapes.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

constexpr double tolerance = 1e-15 * pi;

/// Area of the part of the unit disc with x > a and y > b, the corner (a, b) within the disc.
double cornerArea(double a, double b)
{
    if (b < 0) return segmentArea(a) - cornerArea(a, -b);
    const double xb = std::sqrt(1 - b * b);
    const auto primitive = [](double x) { return 0.5 * (x * std::sqrt(1 - x * x) + std::asin(x)); };
    return primitive(xb) - primitive(a) - b * (xb - a);
}

void expectNear(const AreaMoment& got, double area, const Point2& centroid)
{
    EXPECT_NEAR(got.area, area, tolerance);
    EXPECT_NEAR(got.centroid.x(), centroid.x(), 1e-14);
    EXPECT_NEAR(got.centroid.y(), centroid.y(), 1e-14);
}

}  // namespace

TEST(Polygon, HasAreaAndCentroidOfATriangle)
{
    const AreaMoment t = polygon({{0, 0}, {3, 0}, {0, 6}});
    EXPECT_DOUBLE_EQ(t.area, 9);
    EXPECT_DOUBLE_EQ(t.centroid.x(), 1);
    EXPECT_DOUBLE_EQ(t.centroid.y(), 2);
}

TEST(Polygon, IsNegativeClockwise)
{
    const AreaMoment s = polygon({{0, 0}, {0, 2}, {2, 2}, {2, 0}});
    EXPECT_DOUBLE_EQ(s.area, -4);
    EXPECT_DOUBLE_EQ(s.centroid.x(), 1);
}

TEST(Polygon, CollapsedToALineHasNoAreaAndAFiniteCentroid)
{
    const AreaMoment s = polygon({{1, 1}, {2, 2}, {3, 3}});
    EXPECT_EQ(s.area, 0);
    EXPECT_DOUBLE_EQ(s.centroid.x(), 2);
}

TEST(Polygon, KeepsItsDigitsFarFromTheOrigin)
{
    const double x = 1e6, h = 0x1p-10;
    const AreaMoment s = polygon(rectangle(x, x, x + h, x + h));
    EXPECT_EQ(s.area, h * h);
}

TEST(DiscPolygon, DiscWithinTheCellIsTheDiscExactly)
{
    for (double r : {1e-9, 0.3, 0.5})
    {
        const Point2 centre(0.5, 0.5);
        const AreaMoment a = discPolygon(centre, r, rectangle(0, 0, 1, 1));
        EXPECT_EQ(a.area, pi * r * r);
        EXPECT_EQ(a.centroid, centre);
    }
}

TEST(DiscPolygon, PolygonsAroundTheDiscGiveTheDiscExactly)
{
    for (int n : {3, 4, 5, 7, 60})
    {
        for (double reach : {1.0, 1.01, 3.0, 1e3, 1e8})
        {
            for (double turn : {0.0, 0.1, 1.0})
            {
                Polygon cell;
                const double apothem = 1.0001 * reach;
                for (int k = 0; k < n; ++k)
                    cell.push_back(rotated({apothem / std::cos(pi / n), 0}, turn + 2 * pi * k / n));
                const AreaMoment a = unitDisc(cell);
                EXPECT_EQ(a.area, pi) << n << ' ' << reach << ' ' << turn;
                EXPECT_EQ(a.centroid, Point2(0, 0));
            }
        }
    }
}

TEST(DiscPolygon, DiscInTheBayOfACellDoesNotOverlap)
{
    const Polygon horseshoe = {{-3, -3}, {3, -3}, {3, 3}, {2, 3}, {2, -2}, {-2, -2}, {-2, 3}, {-3, 3}};
    EXPECT_EQ(unitDisc(horseshoe).area, 0);
    EXPECT_EQ(unitDisc(horseshoe).centroid, Point2(0, 0));
}

TEST(DiscPolygon, CellWithinTheDiscIsTheCellExactly)
{
    const Polygon cell = {{0.1, 0.2}, {0.3, 0.1}, {0.5, 0.4}, {0.2, 0.5}};
    const AreaMoment a = unitDisc(cell), exact = polygon(cell);
    EXPECT_EQ(a.area, exact.area);
    EXPECT_EQ(a.centroid, exact.centroid);
}

TEST(DiscPolygon, DisjointPairIsEmptyAndItsCentroidTheCentre)
{
    const Point2 centre(7, 8);
    for (const Polygon& cell : {rectangle(9, 7, 10, 9), Polygon{{7, 9.6}, {8.6, 8}, {9, 9.5}}})
    {
        const AreaMoment a = discPolygon(centre, 1, cell);
        EXPECT_EQ(a.area, 0);
        EXPECT_EQ(a.centroid, centre);
    }
}

TEST(DiscPolygon, CentreOnAnEdgeGivesAHalfDisc)
{
    expectNear(unitDisc(rectangle(-2, 0, 3, 4)), pi / 2, {0, 4 / (3 * pi)});
}

TEST(DiscPolygon, CentreOnAVertexGivesAQuarterDisc)
{
    expectNear(unitDisc(rectangle(0, 0, 3, 4)), pi / 4, {4 / (3 * pi), 4 / (3 * pi)});
}

TEST(DiscPolygon, HalfPlaneGivesACircularSegment)
{
    for (double h : {-0.999, -0.5, -1e-3, 0.0, 1e-8, 0.2, 0.7, 0.99, 0.999999})
    {
        const double area = segmentArea(h), moment = 2. / 3 * std::pow(1 - h * h, 1.5);
        const AreaMoment a = unitDisc(rectangle(h, -5, 5, 5));
        EXPECT_NEAR(a.area, area, tolerance) << h;
        EXPECT_NEAR(a.area * a.centroid.x(), moment, 1e-15) << h;
        EXPECT_NEAR(a.centroid.y(), 0, 1e-9) << h;
    }
}

TEST(DiscPolygon, CornerOfACellHasItsClosedForm)
{
    for (double a : {-0.6, -0.1, 0.0, 0.3, 0.7})
    {
        for (double b : {-0.7, 0.0, 0.2, 0.71})
        {
            EXPECT_NEAR(unitDisc(rectangle(a, b, 9, 8)).area, cornerArea(a, b), tolerance) << a << ' ' << b;
        }
    }
}

TEST(DiscPolygon, FourSidesThatCutLeaveFourSegments)
{
    const double h = 0.9;
    expectNear(unitDisc(rectangle(-h, -h, h, h)), pi - 4 * segmentArea(h), {0, 0});
}

TEST(DiscPolygon, StripIsTheDifferenceOfTwoSegments)
{
    EXPECT_NEAR(unitDisc(rectangle(-3, 0.1, 3, 0.4)).area, segmentArea(0.1) - segmentArea(0.4), tolerance);
}

TEST(DiscPolygon, InscribedPolygonIsCovered)
{
    const double h = std::sqrt(0.5);
    expectNear(unitDisc(rectangle(-h, -h, h, h)), 2, {0, 0});

    Polygon octagon;
    for (int k = 0; k < 8; ++k) octagon.push_back(rotated({1, 0}, k * pi / 4));
    expectNear(unitDisc(octagon), 2 * std::sqrt(2.), {0, 0});
}

TEST(DiscPolygon, CircumscribedPolygonCoversTheDisc)
{
    expectNear(unitDisc(rectangle(-1, -1, 1, 1)), pi, {0, 0});
    for (double angle : {0.1, 0.4, 0.7})
    {
        Polygon square = rectangle(-1, -1, 1, 1);
        for (Point2& p : square) p = rotated(p, angle);
        expectNear(unitDisc(square), pi, {0, 0});
    }
}

TEST(DiscPolygon, ContactInAPointIsEmpty)
{
    EXPECT_NEAR(unitDisc(rectangle(1, -1, 2, 1)).area, 0, tolerance);
    EXPECT_NEAR(unitDisc({{1, 0}, {2, -1}, {2, 1}}).area, 0, tolerance);
    EXPECT_NEAR(unitDisc({{0.6, 0.8}, {-1, 2}, {0, 1}}).area, segmentArea(std::cos(std::atan2(0.6, 0.8) / 2)), 1e-15);
}

TEST(DiscPolygon, NearlyTangentEdgeIsContinuous)
{
    for (double e : {1e-12, 1e-14, 1e-15, 3e-16})
    {
        const double segment = 4. / 3 * std::sqrt(2.) * std::pow(e, 1.5);
        EXPECT_NEAR(unitDisc(rectangle(1 - e, -2, 3, 2)).area, segment, tolerance);
        EXPECT_NEAR(unitDisc(rectangle(-3, -2, 1 - e, 2)).area, pi - segment, tolerance);
        EXPECT_EQ(unitDisc(rectangle(1 + e, -2, 3, 2)).area, 0);
        EXPECT_NEAR(unitDisc(rectangle(-3, -2, 1 + e, 2)).area, pi, tolerance);
    }
}

TEST(DiscPolygon, CollinearAndRepeatedVerticesChangeNothing)
{
    const Polygon plain = {{0.2, -0.3}, {2, -0.3}, {2, 1.5}, {0.2, 1.5}};
    const Polygon refined = {{0.2, -0.3}, {0.6, -0.3}, {0.6, -0.3}, {2, -0.3},     {2, -0.3},
                             {2, 0.1},    {2, 1.5},    {0.2, 1.5},  {0.2, 0.9798}, {0.2, 0.0}};
    const AreaMoment a = unitDisc(plain);
    expectNear(unitDisc(refined), a.area, a.centroid);
}

TEST(DiscPolygon, NonConvexCellIsTheSumOfItsConvexParts)
{
    for (double x : {-0.5, 0.0, 0.5, 1.0, 1.7})
    {
        for (double y : {-0.4, 0.3, 1.0, 1.2})
        {
            for (double r : {0.1, 0.5, 1.0, 1.5, 4.0})
            {
                const Point2 c(x, y);
                const AreaMoment whole = discPolygon(c, r, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
                const AreaMoment foot = discPolygon(c, r, rectangle(0, 0, 2, 1));
                const AreaMoment leg = discPolygon(c, r, rectangle(0, 1, 1, 2));
                EXPECT_NEAR(whole.area, foot.area + leg.area, 1e-15 * pi * r * r);

                const Point2 moment =
                    whole.area * (whole.centroid - c) - foot.area * (foot.centroid - c) - leg.area * (leg.centroid - c);
                EXPECT_LT(moment.norm(), 2e-15 * r * r * r);
            }
        }
    }
}

TEST(DiscPolygon, CombCrossesTheCircleManyTimes)
{
    Polygon comb = {{-2, -2}, {2, -2}};
    double teeth = segmentArea(-1) - segmentArea(-0.5);  // the part below y = -0.5
    for (int k = 9; k >= -9; k -= 2)
    {
        const double right = 0.1 * k, left = 0.1 * (k - 1);
        comb.insert(comb.end(), {{right, -0.5}, {right, 2}, {left, 2}, {left, -0.5}});
        teeth += unitDisc(rectangle(left, -0.5, right, 2)).area;
    }
    comb.erase(comb.begin() + 2);
    comb.erase(comb.end() - 1);
    comb.insert(comb.begin() + 2, {{2, -0.5}, {0.9, -0.5}});
    comb.insert(comb.end(), {{-1.0, -0.5}, {-2, -0.5}});
    EXPECT_NEAR(unitDisc(comb).area, teeth, 4 * tolerance);
}

TEST(DiscPolygon, SpiralWindsAroundTheDisc)
{
    Polygon spiral;
    const int n = 60;
    for (int k = 0; k <= n; ++k) spiral.push_back(rotated({1.2 + 0.02 * k, 0}, 4 * pi * k / n));
    for (int k = n; k >= 0; --k) spiral.push_back(rotated({1.5 + 0.02 * k, 0}, 4 * pi * k / n));
    EXPECT_EQ(unitDisc(spiral).area, 0);
}

TEST(DiscPolygon, SliversHaveFiniteCentroidsWithinDiscAndCell)
{
    for (double e : {1e-3, 1e-6, 1e-8, 1e-10, 1e-13, 1e-15, 1e-16})
    {
        const Polygon slivers[] = {
            rectangle(1 - e, -2, 3, 2),                                            // circular segment
            rectangle(-0.5, 0.3, 0.5, 0.3 + e),                                    // thin cell
            {{std::sqrt(0.5) - e, std::sqrt(0.5) - e}, {2, 0.9}, {0.9, 2}},        // corner
            {{0, 0}, {2, 1}, {2, 1 + e}},                                          // needle
            {{std::sqrt(1 - e), 0}, {std::sqrt(1 - e) + 1, e}, {1, 2 * e + 1e-9}}  // nearly tangent needle
        };
        for (const Polygon& cell : slivers)
        {
            const AreaMoment a = unitDisc(cell);
            EXPECT_GE(a.area, 0);
            EXPECT_LE(a.area, std::min(std::abs(polygon(cell).area) * (1 + 1e-9) + tolerance, pi));
            if (a.area == 0) continue;

            Point2 low = cell[0], high = cell[0];
            for (const Point2& p : cell)
            {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            for (int i : {0, 1})
            {
                EXPECT_GE(a.centroid[i], std::max(low[i], -1.0) - 1e-15);
                EXPECT_LE(a.centroid[i], std::min(high[i], 1.0) + 1e-15);
            }
        }
    }
}

TEST(DiscPolygon, ThinCellKeepsItsRelativeAccuracy)
{
    const double e = 1e-6;
    EXPECT_NEAR(unitDisc(rectangle(-0.5, 0, 0.5, e)).area / e, 1, 1e-15);
    EXPECT_NEAR(unitDisc(rectangle(0, 0, 2, e)).area / e, 1 - e * e / 6, 1e-9);
}

TEST(DiscPolygon, HugeAndTinyCellsDoNotOverflow)
{
    for (double size : {1e-300, 1e-30, 1e30})
    {
        const AreaMoment a = unitDisc(rectangle(0, 0, size, size));
        EXPECT_NEAR(a.area, std::min(size * size, pi / 4), tolerance);
    }
    EXPECT_NEAR(discPolygon({0, 0}, 1e-20, rectangle(0, 0, 1, 1)).area / 1e-40, pi / 4, 1e-14);
}
