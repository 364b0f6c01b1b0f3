// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Grains that are put in: the others stay what and where they are, and at rest if they were.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace
{

constexpr int height = 8;

template <int D>
Scene<D> column()
{
    Scene<D> scene;
    scene.addFloor();
    for (int k = 0; k < height; ++k)
    {
        scene.add(up<D>(1 + 2 * k));
    }
    return scene;
}

template <int D>
void expectColumnToStayAtRest()
{
    auto dynamics = column<D>().dynamics();
    for (int i = 0; i < 50; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 1e-3);
    }
    const nscd::Grains<D> before = dynamics.grains();
    const auto contacts = dynamics.contacts();

    Scene<D> more;
    more.add(5 * nscd::Vector<D>::Unit(0) + up<D>(1));
    more.add(10 * nscd::Vector<D>::Unit(0) + up<D>(9));
    nscd::Grains<D> grains = more.dynamics().grains();
    grains.id = {200, 201};
    grains.velocity[1] = up<D>(-1);
    dynamics.add(grains);

    ASSERT_EQ(dynamics.grains().size(), height + 2u);
    for (int k = 0; k < height; ++k)
    {
        EXPECT_EQ(dynamics.grains().id[k], before.id[k]);
        EXPECT_EQ(dynamics.grains().position[k], before.position[k]);
    }
    EXPECT_EQ(dynamics.grains().id[height], 200);
    EXPECT_EQ(dynamics.contactImpulse().size(), height + 2u);
    EXPECT_EQ(dynamics.contacts().size(), contacts.size());

    // With the impulses kept there is next to nothing to solve; without them the column takes many sweeps
    const nscd::StepReport report = fall<D>(dynamics, up<D>(-g), 1e-3);
    EXPECT_LE(report.sweeps, 2);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.active, height + 1u);
    EXPECT_NEAR(dynamics.grains().velocity[height + 1].dot(up<D>(1)), -1 - 1e-3 * g, 1e-12);
}

}  // namespace

TEST(Add, LeavesTheOthersAtRest2D) { expectColumnToStayAtRest<2>(); }
TEST(Add, LeavesTheOthersAtRest3D) { expectColumnToStayAtRest<3>(); }

TEST(Add, FillsAnEmptyScene)
{
    Scene<3> floor;
    floor.addFloor();
    auto dynamics = floor.dynamics();
    ASSERT_EQ(dynamics.grains().size(), 0u);
    dynamics.add(column<3>().dynamics().grains());
    EXPECT_EQ(fall<3>(dynamics, up<3>(-g), 1e-3).contacts, std::size_t(height));
}

TEST(Add, RefusesWhatTheConstructorDoes)
{
    auto dynamics = column<2>().dynamics();
    nscd::Grains<2> grains = column<2>().dynamics().grains();
    grains.radius[3] = -1;
    EXPECT_THROW(dynamics.add(grains), std::invalid_argument);
    EXPECT_EQ(dynamics.grains().size(), std::size_t(height));
}
