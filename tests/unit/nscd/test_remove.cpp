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

TEST(Remove, LeavesTheOthersTheirContacts)
{
    // Towers of two, 5 m apart: two contacts each
    Scene<2> scene;
    scene.addFloor();
    for (int k = 0; k < 4; ++k)
    {
        scene.add({5.0 * k, 1});
        scene.add({5.0 * k, 3});
    }
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, up<2>(-g), 1e-3);
    const auto before = dynamics.contacts();
    ASSERT_EQ(before.size(), 8u);

    // The second tower; then the first, and the upper one of the last
    dynamics.remove({false, false, true, true, false, false, false, false});
    EXPECT_EQ(dynamics.contacts().size(), 6u);
    dynamics.remove({true, true, false, false, false, true});
    const auto after = dynamics.contacts();
    ASSERT_EQ(after.size(), 3u);
    for (const auto& contact : after)
    {
        const auto same = std::find_if(before.begin(), before.end(),
                                       [&](const auto& was) { return was.point == contact.point; });
        ASSERT_NE(same, before.end());
        EXPECT_EQ(same->first, contact.first + 4);
        EXPECT_EQ(same->second, contact.second < 0 ? contact.second : contact.second + 4);
        EXPECT_EQ(same->force, contact.force);
    }

    fall<2>(dynamics, up<2>(-g), 1e-3);
    EXPECT_EQ(dynamics.contacts().size(), 3u);
    dynamics.remove({true, true, true});
    EXPECT_TRUE(dynamics.contacts().empty());
}

TEST(Remove, RefusesAListOfAnotherLength)
{
    auto dynamics = agitated<2>(2, 0).dynamics();
    EXPECT_THROW(dynamics.remove({true}), std::invalid_argument);
}
