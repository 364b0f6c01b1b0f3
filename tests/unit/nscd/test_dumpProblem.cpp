// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The problem of a step, written for other solvers: what was found solves it.

#include "Scene.hpp"

#include "nscd/problem/Fclib.hpp"
#include "nscd/shape/Cluster.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace
{

template <class T>
class Dump : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Dump, Dimensions);

template <int D>
void expectSolved(nscd::ContactDynamics<D>& dynamics, double tolerance)
{
    const std::string file = testing::TempDir() + "nscd_" + std::to_string(getpid()) + "_problem.hdf5";
    dynamics.dumpContactProblem(file);
    const auto read = std::get<nscd::FclibProblem<D>>(nscd::readFclib(file));
    ASSERT_TRUE(read.solution);
    EXPECT_GT(read.problem.contacts(), 3);
    // the natural map is bounded by a small multiple of the residual that the step was solved to
    EXPECT_LT(nscd::residual(read.problem, read.solution->r).worst, 20 * tolerance);
    std::remove(file.c_str());
}

}  // namespace

TYPED_TEST(Dump, OfGrainsInABoxIsSolvedByTheStepsImpulses)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene = agitated<D>(D == 2 ? 6 : 4, 0.3);
    scene.settings.tolerance = 1e-12;
    scene.settings.maxSweeps = 10000;
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 60; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 5e-3);
    }
    expectSolved(dynamics, 1e-12 / 5e-3);
}

TYPED_TEST(Dump, OfClustersInAPeriodicBoxOnAMovingFloorIsSolvedByTheStepsImpulses)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.4);
    scene.settings.tolerance = 1e-12;
    scene.settings.maxSweeps = 10000;
    scene.settings.period[0] = 16;
    scene.grains.clusters.push_back(nscd::makeRod<D>(3, 2));
    if constexpr (D == 2)
    {
        scene.walls.push_back({{-100, 0}, {100, 0}, 1, 0});
    }
    else
    {
        scene.walls.push_back(nscd::Plane{{0, 0, 0}, {0, 0, 1}, 1, 0});
    }
    for (int k = 0; k < 12; ++k)
    {
        scene.add((4 * (k % 4) + 0.3 * (k / 4)) * nscd::Vector<D>::UnitX() + up<D>(1.5 + 2.5 * (k / 4)),
                  nscd::Vector<D>::Zero(), 1.9);
        scene.grains.shape.back() = 0;
    }
    nscd::ContactDynamics<D> dynamics(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF,
                                      {nscd::WallBody<D>()});
    dynamics.setWallMotion(0, 0.3 * nscd::Vector<D>::UnitX(), nscd::Spin<D>::Zero());
    for (int i = 0; i < 200; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 5e-3);
    }
    expectSolved(dynamics, 1e-12 / 5e-3);
}

TYPED_TEST(Dump, OfNothingIsRefused)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.add(up<D>(5));
    auto dynamics = scene.dynamics();
    EXPECT_THROW(dynamics.dumpContactProblem("nothing.hdf5"), std::runtime_error);
}
