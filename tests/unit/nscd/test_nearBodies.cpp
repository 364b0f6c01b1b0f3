// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Heat of a grain of unit radius near walls of several facets, over that near one flat wall.

#include "Surfaces.hpp"

#include "nscd/heat/NearBodies.hpp"
#include "nscd/heat/NearPair.hpp"

#include <gtest/gtest.h>

#include <cmath>

using nscd::NearPair;
using nscd::Vector;
using nscd::Walls;

namespace nearBodiesTest
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double lens = 0.2, least = 1e-8, reach = 1.5, depth = 1;

template <int D>
double throughFluid(const NearPair& pair)
{
    return D == 2 ? nscd::gap::cylinders(pair, lens, least) : nscd::gap::spheres(pair, lens, least);
}

template <int D>
double radiation(const NearPair& pair)
{
    return D == 2 ? nscd::sight::cylinders(pair, 2 * reach) : nscd::sight::spheres(pair, 2 * reach);
}

/// Sum over the walls near a centre.
template <int D, class Law>
double sum(const Walls<D>& walls, const Vector<D>& centre, Law&& law)
{
    nscd::Grains<D> grains;
    grains.resize(1);
    grains.radius[0] = 1;
    grains.position[0] = centre;
    double result = 0;
    for (const nscd::NearBodies& near : nscd::nearBodies<D>(grains, nscd::WallContact<D>(walls), reach, {}))
    {
        result += nscd::ofOwnPart(near.own,
                                  [&](double beside) {
                                      return law(NearPair{1, infinity, near.distance, depth, beside});
                                  });
    }
    return result;
}

/// A wall along a chain of points in the plane, in space along the third axis, too.
template <int D>
Walls<D> along(const nscd::Vectors<2>& points)
{
    Walls<D> walls;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
        const Vector<2>&a = points[i], &b = points[i + 1];
        if constexpr (D == 2)
        {
            walls.push_back(nscd::Segment{a, b});
        }
        else
        {
            addParallelogram(walls, {a[0], a[1], -9}, {b[0] - a[0], b[1] - a[1], 0}, {0, 0, 18}, 1, i);
        }
    }
    return walls;
}

template <int D>
Vector<D> at(double x, double y)
{
    Vector<D> result = Vector<D>::Zero();
    result[0] = x;
    result[1] = y;
    return result;
}

/// A round wall of n facets whose middles are at a distance from the origin, one of them below it unless turned [rad].
template <int D>
Walls<D> drum(double radius, int n, double turned = 0)
{
    nscd::Vectors<2> corners;
    for (int i = 0; i <= n; ++i)
    {
        const double angle = -M_PI / 2 + turned + 2 * M_PI * (i % n - 0.5) / n;
        corners.push_back(radius / std::cos(M_PI / n) * Vector<2>(std::cos(angle), std::sin(angle)));
    }
    return along<D>(corners);
}

template <int D>
struct Law
{
    static constexpr int dimension = D;
};

template <class L>
class HollowWall : public testing::Test
{
};

using Dimensions = testing::Types<Law<2>, Law<3>>;
TYPED_TEST_SUITE(HollowWall, Dimensions);

}  // namespace

TYPED_TEST(HollowWall, ThatIsNearlyFlatIsAFlatOne)
{
    constexpr int D = TypeParam::dimension;
    const double distance = 1.03;
    const NearPair flat{1, infinity, distance, depth};
    for (const double slope : {0.0, 1e-9, 1e-7, 1e-5})
    {
        for (const double x : {0.0, 1e-6, 0.1, 0.5, 2.0})
        {
            const Walls<D> walls = along<D>({{-9, 9 * slope}, {0, 0}, {9, 9 * slope}});
            // The joint is a straight line that 64 directions follow to 1 %
            const double bound = D == 2 || x == 0 ? 1e-3 : 0.01;
            EXPECT_NEAR(sum<D>(walls, at<D>(x, distance), throughFluid<D>) / throughFluid<D>(flat), 1, bound) << x;
            EXPECT_NEAR(sum<D>(walls, at<D>(x, distance), radiation<D>) / radiation<D>(flat), 1, bound) << x;
        }
    }
}

TYPED_TEST(HollowWall, ThatIsRoundDoesNotDependOnItsFacets)
{
    constexpr int D = TypeParam::dimension;
    for (const double ratio : {5.0, 8.0})
    {
        const auto value = [&](int n, bool joint, const auto& law)
        { return sum<D>(drum<D>(ratio, n, joint ? M_PI / n : 0), at<D>(0, 1.05 - ratio), law); };
        for (const auto& law : {throughFluid<D>, radiation<D>})
        {
            const double fine = value(1024, false, law);
            EXPECT_NEAR(value(64, true, law) / value(64, false, law), 1, 0.03) << ratio;
            EXPECT_NEAR(value(64, false, law) / fine, 1, 0.06) << ratio;
            EXPECT_NEAR(value(256, false, law) / fine, 1, 0.02) << ratio;
        }
    }
}

TEST(Tube, AroundADiscTakesAllItsLightAndConductsAsItsArea)
{
    for (const double radius : {1.05, 1.19})
    {
        const Walls<2> tube = drum<2>(radius, 256);
        EXPECT_NEAR(sum<2>(tube, {0, 0}, radiation<2>) / (2 * M_PI * depth), 1, 1e-9);
        // Lines across the gap, each across the wall; facets are straight
        EXPECT_NEAR(sum<2>(tube, {0, 0}, throughFluid<2>) / (2 * M_PI * radius * depth / (radius - 1)), 1, 1e-3);
    }
}

TEST(Tube, AroundASphereIsSeenWhollyOutToTheRange)
{
    const double radius = 1.1, seen = 4 * M_PI * std::sqrt(1 - std::pow(radius / (2 * reach), 2));
    for (const int facets : {16, 64, 256, 1024})
    {
        EXPECT_NEAR(sum<3>(drum<3>(radius, facets), {0, 0, 0}, radiation<3>) / seen, 1, 0.025) << facets;
    }
}

TYPED_TEST(HollowWall, OfTwoAtARightAngleHasTheLensesOfBothAndWhatIsSeenOfThem)
{
    constexpr int D = TypeParam::dimension;
    const double d = 1.03;
    const Walls<D> corner = along<D>({{0, 9}, {0, 0}, {9, 0}});
    const NearPair flat{1, infinity, d, depth};
    EXPECT_NEAR(sum<D>(corner, at<D>(d, d), throughFluid<D>) / (2 * throughFluid<D>(flat)), 1, 1e-12);

    // Directions to each out to the joint, by the midpoint rule
    const double rim = std::sqrt(4 * reach * reach - d * d);
    double seen = 0;
    if (D == 2)
    {
        seen = 2 * (std::acos(d / (2 * reach)) + M_PI / 4);
    }
    else
    {
        const int n = 1500;
        const double h = 2 * rim / n;
        for (double x = -rim + h / 2; x < d; x += h)
        {
            for (double z = -rim + h / 2; z < rim; z += h)
            {
                const double r2 = x * x + z * z;
                seen += r2 < rim * rim ? 2 * h * h * d * std::pow(d * d + r2, -1.5) : 0;
            }
        }
    }
    EXPECT_NEAR(sum<D>(corner, at<D>(d, d), radiation<D>) / seen, 1, 3e-3);
}

TYPED_TEST(HollowWall, ThatStandsOnItsEdgeIsOneWall)
{
    constexpr int D = TypeParam::dimension;
    const NearPair flat{1, infinity, 1.05, depth};
    const Walls<D> ridge = along<D>({{-9, -1}, {0, 0}, {9, -1}});
    EXPECT_DOUBLE_EQ(sum<D>(ridge, at<D>(0, 1.05), throughFluid<D>), throughFluid<D>(flat));
}

}  // namespace nearBodiesTest
