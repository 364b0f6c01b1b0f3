// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Grains that are taken away: the others stay what and where they are, and at rest if they were.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace
{

template <int D>
void expectColumnToStayAtRest()
{
    Scene<D> scene;
    scene.addFloor();
    constexpr int height = 8;
    for (int k = 0; k < height; ++k)
    {
        scene.add(up<D>(1 + 2 * k));
        scene.add(5 * nscd::Vector<D>::Unit(0) + up<D>(3 + 2 * k));
    }
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 50; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 1e-3);
    }

    // Every second grain is not of the column
    std::vector<bool> gone;
    for (int i = 0; i < 2 * height; ++i)
    {
        gone.push_back(i % 2 == 1);
    }
    const nscd::Grains<D> before = dynamics.grains();
    dynamics.remove(gone);
    ASSERT_EQ(dynamics.grains().size(), static_cast<std::size_t>(height));
    for (int k = 0; k < height; ++k)
    {
        EXPECT_EQ(dynamics.grains().id[k], before.id[2 * k]);
        EXPECT_EQ(dynamics.grains().position[k], before.position[2 * k]);
    }

    // With the impulses kept there is next to nothing to solve; without them the column takes many sweeps
    const nscd::StepReport report = fall<D>(dynamics, up<D>(-g), 1e-3);
    EXPECT_LE(report.sweeps, 2);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.maxVelocity, 1e-3);
}

}  // namespace

TEST(Remove, LeavesTheOthersAtRest2D) { expectColumnToStayAtRest<2>(); }
TEST(Remove, LeavesTheOthersAtRest3D) { expectColumnToStayAtRest<3>(); }

TEST(Remove, TakesAllOrNone)
{
    auto dynamics = agitated<2>(3, 0).dynamics();
    dynamics.remove(std::vector<bool>(dynamics.grains().size(), false));
    const std::size_t n = dynamics.grains().size();
    EXPECT_GT(n, 0u);
    dynamics.remove(std::vector<bool>(n, true));
    EXPECT_EQ(dynamics.grains().size(), 0u);
    EXPECT_EQ(fall<2>(dynamics, up<2>(-g), 1e-3).contacts, 0u);
}

TEST(Remove, LeavesNoContactsUntilTheNextStep)
{
    Scene<2> scene;
    scene.addFloor();
    for (int k = 0; k < 3; ++k)
    {
        scene.add({5.0 * k, 1});
    }
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, up<2>(-g), 1e-3);
    EXPECT_EQ(dynamics.contacts().size(), 3u);
    dynamics.remove({true, false, false});
    EXPECT_EQ(dynamics.contacts().size(), 0u);
    fall<2>(dynamics, up<2>(-g), 1e-3);
    ASSERT_EQ(dynamics.contacts().size(), 2u);
    for (const auto& contact : dynamics.contacts())
    {
        EXPECT_NEAR(contact.point.x(), 5 * (contact.first + 1), 1e-9);
    }
}

TEST(Remove, RefusesAListOfAnotherLength)
{
    auto dynamics = agitated<2>(2, 0).dynamics();
    EXPECT_THROW(dynamics.remove({true}), std::invalid_argument);
}
