// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Heavy bodies on light ones, and boxes that are too small for their grains.

#include "Scene.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace massRatios
{

template <class T>
class MassRatio : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MassRatio, Dimensions);

constexpr double dt = 1e-3;

template <int D>
Scene<D> onTheFloor()
{
    Scene<D> scene(0.3);
    scene.addFloor();
    scene.settings.tolerance = 1e-6;
    scene.settings.maxSweeps = 200;
    return scene;
}

/// Let the scene rest on the floor for a second: who reports to have converged must be right.
template <int D>
void rest(nscd::ContactDynamics<D> dynamics, int mayFail, const char* what)
{
    int failed = 0;
    double worst = 0;
    for (int i = 0; i < 1000; ++i)
    {
        const auto report = fall<D>(dynamics, up<D>(-g), dt);
        worst = report.converged ? std::max(worst, report.worstOverlap) : worst;
        failed += !report.converged;
    }
    EXPECT_LE(worst, 1e-5) << what;   // ten tolerances; radii are 1
    EXPECT_LE(failed, mayFail) << what;
    for (const auto& x : dynamics.grains().position)
    {
        EXPECT_GT(x[D - 1], 0.99) << what;
    }
}

TYPED_TEST(MassRatio, OfAHeavyGrainOnAColumnIsHeld)
{
    constexpr int D = TestFixture::dimension;
    for (const double ratio : {1e3, 1e4, 1e5, 1e6})
    {
        Scene<D> scene = onTheFloor<D>();
        for (int i = 0; i < 10; ++i)
        {
            scene.add(up<D>(1 + 2 * i));
        }
        scene.add(up<D>(21), up<D>(0), 1, ratio);
        rest<D>(scene.dynamics(), 100, "column");
    }
}

TYPED_TEST(MassRatio, OfHeavyAndLightByTurnsIsHeld)
{
    constexpr int D = TestFixture::dimension;
    for (const double ratio : {1e3, 1e4, 1e5, 1e6})
    {
        Scene<D> scene = onTheFloor<D>();
        for (int i = 0; i < 6; ++i)
        {
            scene.add(up<D>(1 + 2 * i), up<D>(0), 1, i % 2 ? ratio : 1);
        }
        rest<D>(scene.dynamics(), 100, "by turns");
    }
}

TYPED_TEST(MassRatio, OfAFreeLidOnGrainsIsHeld)
{
    constexpr int D = TestFixture::dimension;
    for (const double ratio : {1e3, 1e6})
    {
        Scene<D> scene = onTheFloor<D>();
        for (int i = 0; i < 5; ++i)
        {
            scene.add(up<D>() + 3 * i * nscd::Vector<D>::UnitX());
        }
        if constexpr (D == 2)
        {
            scene.walls.push_back({{-100, 2}, {100, 2}, 1, 0});
        }
        else
        {
            scene.walls.push_back(nscd::Plane{{0, 0, 2}, {0, 0, -1}, 1, 0});
        }
        nscd::WallBody<D> lid;
        lid.position = up<D>(2) + 6 * nscd::Vector<D>::UnitX();
        lid.mass = ratio;
        nscd::ContactDynamics<D> dynamics(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF,
                                          {lid});
        dynamics.setWallLoad(0, ratio * up<D>(-g), nscd::Spin<D>::Zero());
        rest<D>(std::move(dynamics), 100, "lid");
    }
}

TYPED_TEST(MassRatio, OfABoxThatShrinksTooFarStopsWithTheReason)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene = onTheFloor<D>();
    for (int i = 0; i < 4; ++i)
    {
        scene.add(up<D>(1 + 2 * i));
    }
    if constexpr (D == 2)
    {
        scene.walls.push_back({{-100, 8.01}, {100, 8.01}, 1, 0});
    }
    else
    {
        scene.walls.push_back(nscd::Plane{{0, 0, 8.01}, {0, 0, -1}, 1, 0});
    }
    nscd::WallBody<D> press;
    press.velocity = up<D>(-1);
    nscd::ContactDynamics<D> dynamics(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF, {press});
    std::string reason;
    bool hidden = false;
    for (int i = 0; i < 8000 && reason.empty(); ++i)
    {
        try
        {
            const auto report = fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
            hidden = hidden || (report.converged && report.worstOverlap > 1e-4);
        }
        catch (const std::runtime_error& error)
        {
            reason = error.what();
        }
        for (const auto& x : dynamics.grains().position)
        {
            ASSERT_TRUE(x[D - 1] > 0 || !reason.empty());
        }
    }
    EXPECT_FALSE(hidden);
    EXPECT_NE(reason.find("has been pressed through wall"), std::string::npos) << reason;
}

}  // namespace massRatios
