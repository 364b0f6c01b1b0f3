// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Distributions of grain sizes, and how grains are drawn from them.

#include "Messages.hpp"

#include "nscd/packing/SizeDistribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using nscd::Box;
using nscd::SieveCurve;
using nscd::SizeDistribution;

namespace sizeDistributions
{

const Box<2> square{{0, 0}, {1, 1}};
const Box<3> cube{{-1, 0, 0}, {0, 1, 1}};

/// Fraction of the mass in grains of less than a radius; the midpoint rule's error is that of one grain in n.
template <int D>
double massBelow(const SizeDistribution& sizes, double radius)
{
    constexpr int n = 100000;
    double below = 0, total = 0;
    for (int i = 0; i < n; ++i)
    {
        const double r = sizes((i + 0.5) / n);
        total += std::pow(r, D);
        below += r < radius ? std::pow(r, D) : 0;
    }
    return below / total;
}

template <int D>
void expectMassesOfTheSieveCurve()
{
    const std::vector<double> radii{1, 1.5, 2, 3}, passing{0, 0.2, 0.2, 1};
    const auto sizes = nscd::tabulatedSize<D>(radii, passing, SieveCurve::byMass);
    EXPECT_NEAR(massBelow<D>(sizes, 1.25), 0.1, 1e-4);  // evenly spread between two sieves
    EXPECT_NEAR(massBelow<D>(sizes, 1.5), 0.2, 1e-4);
    EXPECT_NEAR(massBelow<D>(sizes, 2), 0.2, 1e-4);
    EXPECT_NEAR(massBelow<D>(sizes, 2.75), 0.8, 1e-4);
    EXPECT_EQ(sizes(0), 1);
    EXPECT_EQ(sizes(1), 3);
    for (double u = 0.001; u < 1; u += 0.001)
    {
        EXPECT_GE(sizes(u), sizes(u - 0.001));
    }
}

template <int D>
void expectSolidFraction(const SizeDistribution& sizes, const Box<D>& box, double solidFraction)
{
    const std::vector<double> radii = nscd::drawRadii<D>(sizes, box, solidFraction, 1);
    double volume = 0, largest = 0;
    for (const double r : radii)
    {
        const double v = (D == 2 ? M_PI : 4 * M_PI / 3) * std::pow(r, D);
        volume += v;
        largest = std::max(largest, v);
    }
    EXPECT_NEAR(volume, solidFraction, largest);  // of a box of volume 1
}

TEST(SizeDistribution, UniformAndConstantAreWhatTheySay)
{
    const auto uniform = nscd::uniformSize(2, 6);
    EXPECT_EQ(uniform(0), 2);
    EXPECT_EQ(uniform(0.25), 3);
    EXPECT_EQ(uniform(1), 6);
    EXPECT_EQ(nscd::constantSize(3)(0.7), 3);
}

TEST(SizeDistribution, NormalHasItsKnownQuantiles)
{
    // 0.841344746 of a normal distribution is below one deviation; seven digits are kept
    const auto wide = nscd::normalSize(10, 0.5, 1, 20);
    EXPECT_NEAR(wide(0.5), 10, 1e-6);
    EXPECT_NEAR(wide(0.841344746), 10.5, 1e-6);
    EXPECT_NEAR(wide(0.158655254), 9.5, 1e-6);

    // Cut at one deviation on either side: half of the upper part is at 0.670672...
    const auto cut = nscd::normalSize(10, 0.5, 9.5, 10.5);
    EXPECT_EQ(cut(0), 9.5);
    EXPECT_EQ(cut(1), 10.5);
    const double tail = 0.5 * std::erfc((cut(0.75) - 10) / 0.5 / std::sqrt(2.0));
    EXPECT_NEAR(tail, 0.5 - 0.25 * std::erf(1 / std::sqrt(2.0)), 1e-6);

    // Far out on one side, where the density falls as exp(-x^2/2)
    const auto far = nscd::normalSize(1, 0.1, 1.5, 2);
    EXPECT_NEAR(std::erfc((far(0.5) - 1) / 0.1 / std::sqrt(2.0)) / std::erfc(5 / std::sqrt(2.0)), 0.5, 1e-4);
}

TEST(SizeDistribution, LognormalIsNormalInTheLogarithm)
{
    const auto sizes = nscd::lognormalSize(1e-3, 0.3, 1e-5, 1e-1);
    EXPECT_NEAR(sizes(0.5) / 1e-3, 1, 1e-6);
    EXPECT_NEAR(std::log(sizes(0.841344746) / 1e-3), 0.3, 1e-6);
    EXPECT_NEAR(sizes(0.1) * sizes(0.9) / 1e-6, 1, 1e-6);
    EXPECT_EQ(nscd::lognormalSize(1, 0.3, 0.8, 1.1)(1), 1.1);
}

TEST(SizeDistribution, TableByNumberIsLinearBetweenItsEntries)
{
    const auto sizes = nscd::tabulatedSize<2>({1, 2, 4}, {0, 0.5, 1}, SieveCurve::byNumber);
    EXPECT_EQ(sizes(0.25), 1.5);
    EXPECT_EQ(sizes(0.5), 2);
    EXPECT_EQ(sizes(0.75), 3);
    EXPECT_EQ(sizes(1), 4);
    const auto two = nscd::tabulatedSize<2>({1, 1.1, 2, 3}, {0, 1, 1, 1}, SieveCurve::byNumber);
    EXPECT_LE(two(0.999), 1.1);
}

TEST(SizeDistribution, TableByMassHasTheMassesOfTheCurve)
{
    expectMassesOfTheSieveCurve<2>();
    expectMassesOfTheSieveCurve<3>();
}

TEST(DrawnRadii, MeetTheSolidFraction)
{
    expectSolidFraction<2>(nscd::constantSize(0.013), square, 0.82);
    expectSolidFraction<3>(nscd::constantSize(0.05), cube, 0.6);
    expectSolidFraction<2>(nscd::lognormalSize(0.01, 0.4, 0.003, 0.03), square, 0.84);
    expectSolidFraction<3>(nscd::tabulatedSize<3>({0.02, 0.03, 0.06}, {0, 0.5, 1}, SieveCurve::byMass), cube, 0.63);
}

TEST(DrawnRadii, FollowTheDistributionToOneGrain)
{
    // The i-th smallest of n lies between the quantiles i/n and (i + 1)/n
    const auto sizes = nscd::normalSize(0.01, 0.002, 0.005, 0.015);
    std::vector<double> radii = nscd::drawRadii<2>(sizes, square, 0.5, 7);
    EXPECT_EQ(radii, nscd::drawRadii<2>(sizes, square, 0.5, 7));
    EXPECT_NE(radii, nscd::drawRadii<2>(sizes, square, 0.5, 8));
    std::sort(radii.begin(), radii.end());
    const double n = static_cast<double>(radii.size());
    EXPECT_GT(n, 1000);
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
        EXPECT_GE(radii[i], sizes(static_cast<double>(i) / n));
        EXPECT_LE(radii[i], sizes(static_cast<double>(i + 1) / n));
    }
}

TEST(SizeDistribution, RefusesSenselessInput)
{
    EXPECT_EQ(invalid([] { nscd::constantSize(0); }), "radius 0 m is not positive");
    EXPECT_EQ(invalid([] { nscd::uniformSize(2, 1); }), "radii from 2 to 1 m are not positive and increasing");
    EXPECT_EQ(invalid([] { nscd::normalSize(1, 0, 1, 2); }),
              "mean 1 m and standard deviation 0 m are not finite and positive");
    EXPECT_EQ(invalid([] { nscd::normalSize(1, 0.1, 1.9, 2); }),
              "radii from 1.9 to 2 m hold nothing of the distribution");
    EXPECT_EQ(invalid([] { nscd::lognormalSize(-1, 1, 1, 2); }),
              "median -1 m and logarithmic deviation 1 are not positive");
    const auto table = [](const std::vector<double>& radii, const std::vector<double>& passing)
    { return invalid([&] { nscd::tabulatedSize<2>(radii, passing, SieveCurve::byMass); }); };
    EXPECT_EQ(table({1}, {1}), "sieve curve: 1 radii and 1 fractions; at least two of each are needed");
    EXPECT_EQ(table({1, 2}, {0, 1, 1}), "sieve curve: 2 radii and 3 fractions; at least two of each are needed");
    EXPECT_EQ(table({0, 2}, {0, 1}), "radius 0 m is not positive");
    EXPECT_EQ(table({1, 2, 2}, {0, 0.5, 1}), "sieve curve: entry 2, 1 below 2 m, does not rise");
    EXPECT_EQ(table({1, 2, 3}, {0, 0.5, 0.4}), "sieve curve: entry 2, 0.4 below 3 m, does not rise");
    EXPECT_EQ(table({1, 2}, {0.1, 1}), "sieve curve: from 0.1 to 1 instead of from 0 to 1");
    const auto draw = [](double radius, double fraction)
    { return invalid([&] { nscd::drawRadii<2>(nscd::constantSize(radius), square, fraction, 1); }); };
    EXPECT_EQ(draw(0.1, 1), "solid fraction 1 is not between 0 and 1");
    EXPECT_EQ(draw(2, 0.5), "solid fraction 0.5 makes 0 grains in this box");
    EXPECT_EQ(draw(1e-6, 0.5), "solid fraction 0.5 makes 1.59155e+11 grains in this box");
}

}  // namespace sizeDistributions
