// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Heat between bodies that do not touch.

#include "nscd/heat/NearPair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using nscd::NearPair;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double lens = 0.2, least = 1e-8;

/// Distance from the line of centres at which the layer of a body of radius r meets the other's surface.
double rim(double r, double other, double distance)
{
    const double reach = (1 + lens) * r;
    const double along =
        std::isinf(other) ? distance : (reach * reach - other * other + distance * distance) / (2 * distance);
    return std::sqrt(std::min(reach * reach - along * along, r * r));
}

double thickness(double r, double other, double distance, double beside)
{
    return distance - std::sqrt(r * r - beside * beside)
           - (std::isinf(other) ? 0 : std::sqrt(other * other - beside * beside));
}

/// By the midpoint rule with points that crowd towards the line of centres.
template <class F>
double integral(double end, F&& f)
{
    const int n = 200000;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
        const double a = end * std::pow(double(i) / n, 3), b = end * std::pow(double(i + 1) / n, 3);
        sum += (b - a) * f(0.5 * (a + b));
    }
    return sum;
}

}  // namespace

TEST(GapOfSpheres, IsTheIntegralOverTheLayerBetweenThem)
{
    for (const double other : {1.0, 2.5, infinity})
    {
        for (const double gap : {1e-4, 0.01, 0.1})
        {
            const double distance = 1 + gap + (std::isinf(other) ? 0 : other);
            const double expected = integral(
                rim(1, other, distance),
                [&](double r) { return 2 * M_PI * r / thickness(1, other, distance, r); });
            EXPECT_NEAR(nscd::gap::spheres({1, other, distance, 1}, lens, least) / expected, 1, 1e-6)
                << other << ' ' << gap;
            if (!std::isinf(other))
            {
                EXPECT_DOUBLE_EQ(nscd::gap::spheres({1, other, distance, 1}, lens, least),
                                 nscd::gap::spheres({other, 1, distance, 1}, lens, least));
            }
        }
    }
}

TEST(GapOfCylinders, IsTheIntegralOverTheLayerBetweenThem)
{
    for (const double other : {1.0, 2.5, infinity})
    {
        for (const double gap : {1e-4, 0.01, 0.1})
        {
            const double distance = 1 + gap + (std::isinf(other) ? 0 : other);
            const double expected = 2 * 0.3
                                    * integral(rim(1, other, distance), [&](double x)
                                               { return 1 / thickness(1, other, distance, x); });
            EXPECT_NEAR(nscd::gap::cylinders({1, other, distance, 0.3}, lens, least) / expected, 1, 1e-6)
                << other << ' ' << gap;
        }
    }
}

TEST(Gap, OfTouchingSpheresGrowsWithTheLogarithmOfTheLeastGap)
{
    // Batchelor and O'Brien (1977): pi k R ln(1/gap) and a constant, for equal spheres
    const NearPair touching{1, 1, 2, 1};
    const double step =
        nscd::gap::spheres(touching, lens, 1e-7) - nscd::gap::spheres(touching, lens, 1e-6);
    EXPECT_NEAR(step / (M_PI * std::log(10)), 1, 1e-5);
}

TEST(Gap, EndsWhereTheLayerEnds)
{
    EXPECT_EQ(nscd::gap::spheres({1, 1, 2.21, 1}, lens, least), 0);
    EXPECT_GT(nscd::gap::spheres({1, 1, 2.19, 1}, lens, least), 0);
    EXPECT_LT(nscd::gap::spheres({1, 1, 2.1999, 1}, lens, least), 0.01);
    EXPECT_EQ(nscd::gap::cylinders({1, infinity, 1.21, 1}, lens, least), 0);
}

TEST(Gap, RowOfSpheresIsTheirNumberTimesOne)
{
    const double one = nscd::gap::spheres({1, 3, 4.1, 1}, lens, least);
    EXPECT_NEAR(nscd::gap::rowOfSpheres({1, 3, 4.1, 8}, lens, least), 2 * one, 1e-12);
}

TEST(Sight, OfCylindersIsThatOfClosedFormsAndRays)
{
    // Equal ones: Howell's catalogue, (sqrt(x^2 - 1) + asin(1/x) - x)/pi of each one's area
    const double x = 1.4;
    const double factor = (std::sqrt(x * x - 1) + std::asin(1 / x) - x) / M_PI;
    EXPECT_NEAR(nscd::sight::cylinders({1, 1, 2 * x, 0.5}, 10) / (2 * M_PI * 0.5 * factor), 1, 1e-12);

    // A thin one sees another's angle
    const double thin = 1e-4, angle = 2 * std::asin(1 / 2.5);
    EXPECT_NEAR(nscd::sight::cylinders({thin, 1, 2.5, 1}, 10) / (thin * angle), 1, 1e-4);
    EXPECT_NEAR(nscd::sight::cylinders({1, infinity, 1, 1}, 1e9) / M_PI, 1, 1e-8);
}

TEST(Sight, OfSpheresIsThatOfSolidAngles)
{
    // Far away: 4 pi R^2 of the share that a disc has of a sphere
    const double d = 100;
    EXPECT_NEAR(nscd::sight::spheres({1, 2, d, 1}, 1e9) / (4 * M_PI * 4 / (4 * d * d)), 1, 1e-3);
    EXPECT_DOUBLE_EQ(nscd::sight::spheres({1, 2, d, 1}, 1e9), nscd::sight::spheres({2, 1, d, 1}, 1e9));
    // Half of what a sphere sees is the wall
    EXPECT_NEAR(nscd::sight::spheres({1, infinity, 1, 1}, 1e12), 2 * M_PI, 1e-9);
    EXPECT_EQ(nscd::sight::spheres({1, infinity, 3, 1}, 3), 0);
}

TEST(Radiation, IsThatOfStefanAndBoltzmann)
{
    EXPECT_NEAR(nscd::radiationCoefficient(300, 1000) * 700 / (5.670374419e-8 * (1e12 - 81e8)), 1, 1e-12);
    EXPECT_DOUBLE_EQ(nscd::greyness(1, 1), 1);
    EXPECT_DOUBLE_EQ(nscd::greyness(0.5, 1), 0.5);
}
