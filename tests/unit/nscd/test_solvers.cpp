// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The solvers find the same impulses.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace solvers
{

constexpr double dt = 1e-3;

constexpr nscd::Solver solvers[] = {nscd::Solver::sweeps, nscd::Solver::queue, nscd::Solver::nesterov};

template <int D>
Scene<D> column(int n)
{
    Scene<D> scene(0.3);
    scene.addFloor();
    for (int k = 0; k < n; ++k)
    {
        scene.add(up<D>(1 + 2 * k));
    }
    return scene;
}

template <class T>
class Solvers : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Solvers, Dimensions);

TYPED_TEST(Solvers, HoldAColumnWithTheWeightAboveEachContact)
{
    constexpr int D = TestFixture::dimension;
    constexpr int n = 12;
    for (const nscd::Solver solver : solvers)
    {
        Scene<D> scene = column<D>(n);
        scene.settings.solver = solver;
        scene.settings.tolerance = 1e-12;
        auto dynamics = scene.dynamics();
        const auto report = fall<D>(dynamics, up<D>(-g), dt);
        EXPECT_TRUE(report.converged);
        EXPECT_GT(report.solves, 0u);
        for (const auto& c : dynamics.contacts())
        {
            const int below = c.second < 0 ? 0 : std::max(c.first, c.second);
            EXPECT_NEAR(std::abs(c.force[D - 1]), (n - below) * g, 1e-4);   // 1e-9 m/s, n^2 times
        }
    }
}

TYPED_TEST(Solvers, AgreeOnAFrictionalCollisionOfManyGrains)
{
    constexpr int D = TestFixture::dimension;
    std::vector<nscd::Vectors<D>> velocity;
    for (const nscd::Solver solver : solvers)
    {
        Scene<D> scene = agitated<D>(D == 2 ? 8 : 4, 0.3);
        scene.settings.solver = solver;
        scene.settings.tolerance = 1e-13;
        scene.settings.maxSweeps = 20000;
        auto dynamics = scene.dynamics();
        for (int i = 0; i < 20; ++i)
        {
            EXPECT_TRUE(fall<D>(dynamics, nscd::Vector<D>::Zero(), 2e-3).converged);
        }
        velocity.push_back(dynamics.grains().velocity);
    }
    for (std::size_t i = 0; i < velocity[0].size(); ++i)
    {
        EXPECT_LT((velocity[1][i] - velocity[0][i]).norm(), 1e-7);   // sparse contacts: one solution
        EXPECT_LT((velocity[2][i] - velocity[0][i]).norm(), 1e-7);
    }
}

TYPED_TEST(Solvers, MomentumSavesMostSweepsOfAColdDeepColumn)
{
    constexpr int D = TestFixture::dimension;
    int sweeps[2];
    for (int k = 0; k < 2; ++k)
    {
        Scene<D> scene = column<D>(40);
        scene.settings.solver = k == 0 ? nscd::Solver::sweeps : nscd::Solver::nesterov;
        scene.settings.tolerance = 1e-7;
        scene.settings.maxSweeps = 20000;
        auto dynamics = scene.dynamics();
        const auto report = fall<D>(dynamics, up<D>(-g), dt);
        EXPECT_TRUE(report.converged);
        sweeps[k] = report.sweeps;
    }
    EXPECT_LT(4 * sweeps[1], sweeps[0]);
}

}  // namespace solvers
