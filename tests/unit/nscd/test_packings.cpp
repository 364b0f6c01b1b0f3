// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Packings: counts, solid fractions, no overlaps, reproducibility, refusals.

#include "Messages.hpp"
#include "Scene.hpp"

#include "nscd/packing/Packing.hpp"

#include <gtest/gtest.h>

using nscd::Box;
using nscd::Vector;
using nscd::Vectors;

namespace
{

template <int D>
void expectInsideAndApart(const Box<D>& box, const Vectors<D>& x, const std::vector<double>& radius)
{
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        EXPECT_TRUE(((x[i] - box.lower).array() >= radius[i] * (1 - 1e-9)).all());
        EXPECT_TRUE(((box.upper - x[i]).array() >= radius[i] * (1 - 1e-9)).all());
        for (std::size_t j = i + 1; j < x.size(); ++j)
        {
            EXPECT_GE((x[i] - x[j]).norm(), (radius[i] + radius[j]) * (1 - 1e-12));
        }
    }
}

const Box<2> square{{-1, 2}, {9, 12}};
const Box<3> cube{{0, 0, 0}, {6, 6, 6}};

}  // namespace

TEST(Lattice, FillsABoxThatFitsExactly)
{
    EXPECT_EQ(nscd::lattice<2>(square, 0.5, 1).size(), 100u);
    EXPECT_EQ(nscd::lattice<3>(cube, 0.5, 1).size(), 216u);
    EXPECT_EQ(nscd::lattice<2>(square, 0.5, 1.1).size(), 81u);
    expectInsideAndApart(cube, nscd::lattice<3>(cube, 0.3, 0.7), std::vector<double>(512, 0.3));
    EXPECT_TRUE(nscd::lattice<2>(square, 6, 12).empty());
}

TEST(Hexagonal, ReachesTheDensestSolidFraction)
{
    const double r = 0.05;
    const auto discs = nscd::hexagonal<2>(square, r);
    EXPECT_NEAR(static_cast<double>(discs.size()) * M_PI * r * r / 100, M_PI / std::sqrt(12), 0.01);
    const auto spheres = nscd::hexagonal<3>(cube, r);
    const double sphere = 4.0 / 3 * M_PI * r * r * r;
    EXPECT_NEAR(static_cast<double>(spheres.size()) * sphere / 216, M_PI / std::sqrt(18), 0.03);   // sides cut off
}

TEST(Hexagonal, NeighboursAreAGapApart)
{
    for (const double gap : {0.0, 0.2})
    {
        const auto discs = nscd::hexagonal<2>(square, 0.5, gap);
        const auto spheres = nscd::hexagonal<3>(cube, 0.5, gap);
        expectInsideAndApart(square, discs, std::vector<double>(discs.size(), 0.5));
        expectInsideAndApart(cube, spheres, std::vector<double>(spheres.size(), 0.5));
        int most = 0;
        for (const Vector<3>& a : spheres)
        {
            int neighbours = 0;
            for (const Vector<3>& b : spheres)
            {
                neighbours += std::abs((a - b).norm() - 1 - gap) < 1e-9;
            }
            most = std::max(most, neighbours);
        }
        EXPECT_EQ(most, 12);
    }
}

TEST(RandomFill, HasNoOverlapsAndIsReproducible)
{
    std::vector<double> radii;
    nscd::Random random(1);
    for (int i = 0; i < 300; ++i)
    {
        radii.push_back(random.uniform(0.05, 0.3));
    }
    const auto x = nscd::randomFill<2>(square, radii, 42);
    expectInsideAndApart(square, x, radii);
    EXPECT_TRUE(sameBits(x, nscd::randomFill<2>(square, radii, 42)));
    EXPECT_FALSE(sameBits(x, nscd::randomFill<2>(square, radii, 43)));
    expectInsideAndApart(cube, nscd::randomFill<3>(cube, radii, 1), radii);
    EXPECT_TRUE(nscd::randomFill<3>(cube, {}, 1).empty());
}

TEST(RandomNumbers, AreTheSameOnEveryPlatform)
{
    nscd::Random random(5489);   // the standard prescribes the 10 000th value of the engine of this seed
    double last = 0;
    for (int i = 0; i < 10000; ++i)
    {
        last = random.uniform(0, 1);
    }
    EXPECT_EQ(last, static_cast<double>(9981545732273789042ull >> 11) * 0x1p-53);
}

TEST(Settle, EndsAtRestInTheBox)
{
    Scene<2> scene(0.3);
    scene.settings.tolerance = 1e-7;
    scene.settings.maxSweeps = 500;
    const std::vector<double> radii(60, 0.01);
    for (const Vector<2>& x : nscd::randomFill<2>({{0, 0}, {0.2, 0.4}}, radii, 1))
    {
        scene.add(x, {0, 0}, 0.01, 1);
    }
    scene.addBox({0.2, 0.4});
    const auto settled = nscd::settle<2>(scene.dynamics(), up<2>(-g), 1e-3, 1e-3, 10);
    EXPECT_TRUE(settled.atRest);
    EXPECT_LT(settled.time, 10);
    EXPECT_LE(settled.maxVelocity, 1e-3);
    EXPECT_GT(settled.time, std::sqrt(2 * 0.01 / g));
    double top = 0;
    for (const Vector<2>& x : settled.grains.position)
    {
        top = std::max(top, x.y());
    }
    EXPECT_LT(top, 0.2);   // 60 discs of solid fraction > 0.7 would reach 0.135
}

TEST(Settle, DoesNotTakeTheTopOfAFlightForRest)
{
    Scene<2> scene;
    scene.settings.tolerance = 1e-7;
    scene.add({0, 0.01}, up<2>(1), 0.01);
    scene.addFloor();
    const auto settled = nscd::settle<2>(scene.dynamics(), up<2>(-g), 1e-3, 1e-2, 10);
    EXPECT_GT(settled.time, 2 / g);   // up and down again
    EXPECT_NEAR(settled.grains.position[0].y(), 0.01, 1e-7);
    EXPECT_FALSE(nscd::settle<2>(scene.dynamics(), up<2>(-g), 1e-3, 1e-2, 1 / g).atRest);
}

TEST(Settle, WaitsForAGrainThatTipsOver)
{
    Scene<2> scene(0.5);
    scene.settings.tolerance = 1e-9;
    const double r = 0.01, tilt = 1e-3;
    scene.walls.push_back({{-r, 0}, {r, 0}, 1});   // a table as wide as the grain
    scene.add({r * (1 + tilt), r * std::sqrt(1 - tilt * tilt)}, {0, 0}, r);
    scene.walls.push_back({{4 * r, -0.1}, {4 * r, 0.1}, 1});
    scene.walls.push_back({{-4 * r, -0.1}, {4 * r, -0.1}, 1});
    scene.walls.push_back({{-4 * r, -0.1}, {-4 * r, 0.1}, 1});
    const auto settled = nscd::settle<2>(scene.dynamics(), up<2>(-g), 1e-3, 1e-3, 10);
    EXPECT_NEAR(settled.grains.position[0].y(), r - 0.1, 1e-6);
}

TEST(Packing, RefusesSenselessInput)
{
    using Invalid = std::invalid_argument;
    const Box<2> empty{{0, 3}, {1, 3}};
    EXPECT_EQ(messageOf<Invalid>([&] { nscd::lattice<2>(empty, 1, 2); }),
              "box: from 3 to 3 m along axis 1 is empty");
    EXPECT_EQ(messageOf<Invalid>([&] { nscd::lattice<2>(square, -1, 2); }), "radius -1 m is not positive");
    EXPECT_EQ(messageOf<Invalid>([&] { nscd::lattice<2>(square, 1, 1.5); }),
              "spacing 1.5 m is less than two radii of 1 m");
    EXPECT_EQ(messageOf<Invalid>([&] { nscd::hexagonal<2>(square, 1, -0.1); }), "gap -0.1 m is negative");
    EXPECT_EQ(messageOf<Invalid>([&] { nscd::randomFill<2>(square, {1, 6}, 0); }),
              "radius 6 m: the box is only 10 m wide");
    EXPECT_EQ(messageOf<Invalid>([&] { nscd::randomFill<2>(square, {1}, 0, 0); }), "maxTries 0 is less than 1");
    EXPECT_EQ(messageOf<std::runtime_error>([&] { nscd::randomFill<2>(square, {4, 4, 4}, 0, 50); }),
              "grain 2 of 3, largest first, found no place in 50 tries");
    const auto settle = [](double dt, double atRest, double maxTime)
    { nscd::settle<2>(agitated<2>(2, 0).dynamics(), up<2>(-g), dt, atRest, maxTime); };
    EXPECT_EQ(messageOf<Invalid>([&] { settle(0, 1, 1); }), "time step 0 s is not positive");
    EXPECT_EQ(messageOf<Invalid>([&] { settle(1, 0, 1); }), "velocity at rest 0 m/s is not positive");
    EXPECT_EQ(messageOf<Invalid>([&] { settle(1, 1, -1); }), "longest time -1 s is not positive");
}
