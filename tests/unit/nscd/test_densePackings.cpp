// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Dense random packings.

#include "Messages.hpp"

#include "nscd/packing/DensePacking.hpp"
#include "nscd/packing/SizeDistribution.hpp"

#include <gtest/gtest.h>

#include <cmath>

using nscd::Box;
using nscd::SizeDistribution;
using nscd::Vector;
using nscd::Vectors;

namespace
{

template <int D>
std::array<bool, D> everyAxis(bool value)
{
    std::array<bool, D> axes;
    axes.fill(value);
    return axes;
}

/// Packings in a box of unit volume.
template <int D>
struct Packing
{
    Box<D> box{Vector<D>::Constant(-3), Vector<D>::Constant(-2)};
    std::array<bool, D> periodic;
    std::vector<double> radii;
    Vectors<D> x;

    Packing(const SizeDistribution& sizes, double solidFraction, const std::array<bool, D>& axes,
            std::uint64_t seed = 1)
        : periodic(axes), radii(nscd::drawRadii<D>(sizes, box, solidFraction, seed)),
          x(nscd::densePacking<D>(box, radii, seed, axes))
    {
    }

    Vector<D> separation(std::size_t i, std::size_t j) const
    {
        Vector<D> d = x[j] - x[i];
        for (int axis = 0; axis < D; ++axis)
        {
            d[axis] -= periodic[axis] ? std::nearbyint(d[axis]) : 0;
        }
        return d;
    }

    void expectNoOverlap() const
    {
        ASSERT_EQ(x.size(), radii.size());
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            for (int axis = 0; axis < D; ++axis)
            {
                const double inset = periodic[axis] ? 0 : radii[i];
                EXPECT_GE(x[i][axis], box.lower[axis] + inset);
                EXPECT_LE(x[i][axis], box.upper[axis] - inset);
            }
            for (std::size_t j = 0; j < i; ++j)
            {
                EXPECT_GE(separation(i, j).norm(), radii[i] + radii[j]);
            }
        }
    }
};

template <int D>
void expectPacked(const SizeDistribution& sizes, double solidFraction, bool periodic)
{
    Packing<D>(sizes, solidFraction, everyAxis<D>(periodic)).expectNoOverlap();
}

}  // namespace

TEST(DensePacking, OfDiscsReachesRandomClosePacking)
{
    // About 1000 discs; walls leave gaps
    expectPacked<2>(nscd::constantSize(0.016), 0.82, true);
    expectPacked<2>(nscd::uniformSize(0.014, 0.018), 0.84, true);
    expectPacked<2>(nscd::uniformSize(0.014, 0.018), 0.82, false);
}

TEST(DensePacking, OfSpheresReachesRandomClosePacking)
{
    // About 1000 spheres; walls that are ten grains apart leave gaps
    expectPacked<3>(nscd::constantSize(0.053), 0.62, true);
    expectPacked<3>(nscd::uniformSize(0.045, 0.06), 0.64, true);
    expectPacked<3>(nscd::constantSize(0.053), 0.58, false);
}

TEST(DensePacking, TakesGrainsOfVeryDifferentSizes)
{
    using nscd::SieveCurve;
    expectPacked<2>(nscd::tabulatedSize<2>({0.005, 0.05}, {0, 1}, SieveCurve::byMass), 0.85, true);
    expectPacked<3>(nscd::tabulatedSize<3>({0.03, 0.15}, {0, 1}, SieveCurve::byMass), 0.65, true);
}

TEST(DensePacking, MayBePeriodicAlongSomeAxes)
{
    const Packing<2> packing(nscd::constantSize(0.02), 0.82, {true, false});
    packing.expectNoOverlap();
    int outside = 0;
    for (const Vector<2>& x : packing.x)
    {
        outside += x.x() < packing.box.lower.x() + 0.02;
    }
    EXPECT_GT(outside, 5);  // grains lie across the periodic boundary: of 25 along it some do
}

TEST(DensePacking, OfSpheresIsRandom)
{
    // Global bond order Q6, by the addition theorem; 0.57 for the face-centred cubic lattice, 1/sqrt(bonds) for
    // bonds in random directions
    const Packing<3> packing(nscd::constantSize(0.053), 0.62, everyAxis<3>(true));
    Vectors<3> bonds;
    for (std::size_t i = 0; i < packing.x.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            const Vector<3> d = packing.separation(i, j);
            if (d.norm() < 1.2 * 2 * 0.053)
            {
                bonds.push_back(d.normalized());
            }
        }
    }
    double sum = 0;
    for (const Vector<3>& a : bonds)
    {
        for (const Vector<3>& b : bonds)
        {
            const double c = std::pow(a.dot(b), 2);
            sum += (((231 * c - 315) * c + 105) * c - 5) / 16;  // Legendre's polynomial of degree 6
        }
    }
    const double n = static_cast<double>(bonds.size());
    EXPECT_GT(n, 4 * static_cast<double>(packing.x.size()));
    EXPECT_LT(std::sqrt(sum) / n, 0.1);
}

TEST(DensePacking, IsTheSameForASeed)
{
    const auto packed = [](std::uint64_t seed)
    { return Packing<2>(nscd::uniformSize(0.03, 0.05), 0.8, everyAxis<2>(false), seed).x; };
    EXPECT_EQ(packed(4), packed(4));
    EXPECT_NE(packed(4), packed(5));
}

TEST(DensePacking, DoesNotDependOnTheUnitOfLength)
{
    const std::vector<double> radii = nscd::drawRadii<2>(nscd::uniformSize(0.03, 0.05), {{0, 0}, {1, 1}}, 0.8, 1);
    std::vector<double> large(radii);
    for (double& r : large)
    {
        r *= 1024;  // a power of two: no round-off
    }
    const auto x = nscd::densePacking<2>({{0, 0}, {1, 1}}, radii, 1);
    const auto y = nscd::densePacking<2>({{0, 0}, {1024, 1024}}, large, 1);
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        EXPECT_EQ((1024 * x[i] - y[i]).norm(), 0);
    }
}

TEST(DensePacking, OfFewGrainsIsFound)
{
    EXPECT_TRUE(nscd::densePacking<2>({{0, 0}, {1, 1}}, {}, 1).empty());
    const auto one = nscd::densePacking<3>({{0, 0, 0}, {1, 1, 1}}, {0.4999}, 1);
    EXPECT_NEAR((one[0] - Vector<3>::Constant(0.5)).norm(), 0, 2e-4);
    // Four discs in a square leave each other no choice
    const auto four = nscd::densePacking<2>({{0, 0}, {1, 1}}, std::vector<double>(4, 0.2499), 3);
    for (const Vector<2>& x : four)
    {
        EXPECT_NEAR(std::abs(x.x() - 0.5), 0.25, 3e-4);
        EXPECT_NEAR(std::abs(x.y() - 0.5), 0.25, 3e-4);
    }
}

TEST(DensePacking, SaysWhenItFindsNone)
{
    const auto tooDense = [](double radius, double solidFraction)
    {
        return messageOf<std::runtime_error>(
            [&] { Packing<3>(nscd::constantSize(radius), solidFraction, everyAxis<3>(true)); });
    };
    for (const double solidFraction : {0.67, 0.75, 0.9})  // 0.74 is the densest that there is
    {
        EXPECT_EQ(tooDense(0.1, solidFraction).find("no packing of "), 0u) << solidFraction;
    }
}

TEST(DensePacking, RefusesSenselessInput)
{
    const auto packed = [](const Box<2>& box, const std::vector<double>& radii, const std::array<bool, 2>& periodic)
    { return invalid([&] { nscd::densePacking<2>(box, radii, 1, periodic); }); };
    EXPECT_EQ(packed({{0, 0}, {1, 0}}, {0.1}, {}), "box: from 0 to 0 m along axis 1 is empty");
    EXPECT_EQ(packed({{0, 0}, {1, 1}}, {0.1, -1}, {}), "radius -1 m is not positive");
    EXPECT_EQ(packed({{0, 0}, {2, 1}}, {0.6}, {}), "radius 0.6 m: the box is only 1 m wide");
    EXPECT_EQ(packed({{0, 0}, {2, 1}}, {0.2}, {false, true}),
              "radius 0.2 m: the periodic box is only 1 m wide, less than three grains");
}
