// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls that move, free walls, clusters and periodic boxes.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace movingBodies
{

constexpr double dt = 1e-3;

template <class T>
class MovingBody : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MovingBody, Dimensions);

/// A wide floor at a height that belongs to wall body 0.
template <int D>
void addMovingFloor(nscd::Walls<D>& walls, double height = 0)
{
    if constexpr (D == 2)
    {
        walls.push_back({{-50, height}, {50, height}, 1, 0});
    }
    else
    {
        const nscd::Vector<3> a(-50, -50, height), b(50, -50, height), c(50, 50, height), d(-50, 50, height);
        walls.push_back(nscd::Triangle{a, b, c, 1, 0});
        walls.push_back(nscd::Triangle{a, c, d, 1, 0});
    }
}

template <int D>
nscd::ContactDynamics<D> withBodies(const Scene<D>& scene, const std::vector<nscd::WallBody<D>>& bodies)
{
    return {scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF, bodies};
}

/// A rod of three members along x, of unit mass, its size being half its length.
template <int D>
Scene<D> rod(double friction, const nscd::Vector<D>& x, double halfLength = 2)
{
    Scene<D> scene(friction);
    scene.grains.clusters.push_back(nscd::makeRod<D>(3, 2));
    scene.add(x, nscd::Vector<D>::Zero(), halfLength);
    scene.grains.shape[0] = 0;
    return scene;
}

TYPED_TEST(MovingBody, LiftedFloorCarriesAGrain)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.3);
    addMovingFloor<D>(scene.walls);
    scene.add(up<D>());
    auto dynamics = withBodies<D>(scene, {{}});
    dynamics.setWallMotion(0, up<D>(0.5), nscd::Spin<D>::Zero());
    for (int i = 0; i < 200; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
    }
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0.5, 1e-10);
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1.1, 1e-9);
    EXPECT_NEAR(dynamics.wallBodies()[0].position[D - 1], 0.1, 1e-12);
}

TYPED_TEST(MovingBody, FloorMeetsAGrainWhateverItsWayInAStep)
{
    constexpr int D = TestFixture::dimension;
    for (const double way : {0.7, 1.3, 2.5, 5.0, 40.0})   // radii in a step
    {
        for (const double gap : {0.1, 0.5, 1.5, 2.5})
        {
            Scene<D> scene;
            addMovingFloor<D>(scene.walls);
            scene.add(up<D>(1 + gap));
            auto dynamics = withBodies<D>(scene, {{}});
            dynamics.setWallMotion(0, up<D>(way / dt), nscd::Spin<D>::Zero());
            const int steps = 1 + static_cast<int>(gap / way);
            for (int i = 0; i < steps; ++i)
            {
                fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
            }
            EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1 + steps * way, 1e-9) << way << ' ' << gap;
        }
    }
}

TYPED_TEST(MovingBody, IsStoppedWhenItBlowsUp)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    addMovingFloor<D>(scene.walls);
    scene.add(up<D>(2));
    auto dynamics = withBodies<D>(scene, {{}});
    dynamics.setWallMotion(0, up<D>(1e9), nscd::Spin<D>::Zero());
    EXPECT_THROW(fall<D>(dynamics, nscd::Vector<D>::Zero(), dt), std::runtime_error);
}

TYPED_TEST(MovingBody, BeltDragsAGrainUntilItRolls)
{
    constexpr int D = TestFixture::dimension;
    constexpr double k = nscd::inertiaFactor<D>;
    Scene<D> scene(0.3);
    addMovingFloor<D>(scene.walls);
    scene.add(up<D>());
    auto dynamics = withBodies<D>(scene, {{}});
    dynamics.setWallMotion(0, nscd::Vector<D>::UnitX(), nscd::Spin<D>::Zero());
    for (int i = 0; i < 300; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
    }
    EXPECT_NEAR(dynamics.grains().velocity[0][0], k / (1 + k), 1e-10);   // friction turns it while it is dragged
}

TYPED_TEST(MovingBody, DrumDragsAGrainWithTheSpeedOfItsSurface)
{
    constexpr int D = TestFixture::dimension;
    for (const double rolling : {0.0, 1e-9})   // closed local solution, and the general one
    {
        Scene<D> scene(1.0);
        nscd::ContactParameters law;
        law.friction = 1;
        law.rolling = rolling;
        scene.table.set(0, 1, law);
        addMovingFloor<D>(scene.walls);
        scene.add(up<D>());
        nscd::WallBody<D> drum;
        drum.position = up<D>(-3);
        auto dynamics = withBodies<D>(scene, {drum});
        nscd::Spin<D> spin = nscd::Spin<D>::Zero();
        spin[D == 2 ? 0 : 1] = D == 2 ? -0.005 : 0.005;
        dynamics.setWallMotion(0, nscd::Vector<D>::Zero(), spin);
        fall<D>(dynamics, up<D>(-g), dt);
        // The contact sticks: of the surface's speed v + r spin, a disc has 1/3 and a sphere 2/7 in v
        const double surface = 3 * 0.005, share = D == 2 ? 1.0 / 3 : 2.0 / 7;
        EXPECT_NEAR(dynamics.grains().velocity[0][0], share * surface, 1e-8);
        EXPECT_NEAR(std::abs(dynamics.grains().spin[0][D == 2 ? 0 : 1]), (1 - share) * surface, 1e-8);
    }
}

TYPED_TEST(MovingBody, TurningFloorTiltsAndTheGrainRollsDown)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(1);
    addMovingFloor<D>(scene.walls);
    scene.add(up<D>());
    auto dynamics = withBodies<D>(scene, {{}});
    nscd::Spin<D> spin = nscd::Spin<D>::Zero();
    spin[D == 2 ? 0 : 1] = D == 2 ? -1.0 : 1.0;   // the side of +x goes down
    const double slope = 0.3;
    dynamics.setWallMotion(0, nscd::Vector<D>::Zero(), spin);
    for (int i = 0; i < 300; ++i)
    {
        fall<D>(dynamics, nscd::Vector<D>::Zero(), slope / 300);
    }
    dynamics.setWallMotion(0, nscd::Vector<D>::Zero(), nscd::Spin<D>::Zero());
    const double before = dynamics.grains().velocity[0].norm();
    for (int i = 0; i < 200; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
    }
    const nscd::Vector<D> down = std::cos(slope) * nscd::Vector<D>::UnitX() - up<D>(std::sin(slope));
    const double expected = g * std::sin(slope) / (1 + nscd::inertiaFactor<D>) * 0.2;
    EXPECT_NEAR(dynamics.grains().velocity[0].dot(down), expected, before + 1e-6);
    EXPECT_LT(dynamics.worstOverlap(), 1e-6);
}

TYPED_TEST(MovingBody, FreeLidRestsOnTheGrainsWithItsWeight)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.3);
    scene.addFloor();
    scene.add(up<D>());
    addMovingFloor<D>(scene.walls, 2);
    nscd::WallBody<D> lid;
    lid.mass = 5;
    auto dynamics = withBodies<D>(scene, {lid});
    dynamics.setWallLoad(0, up<D>(-5 * g), nscd::Spin<D>::Zero());
    for (int i = 0; i < 20; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
    }
    EXPECT_NEAR(dynamics.wallBodies()[0].velocity.norm(), 0, 1e-10);
    double fromFloor = 0;
    for (const auto& c : dynamics.contacts())
    {
        fromFloor = c.second == ~0 ? -c.force[D - 1] : fromFloor;
    }
    EXPECT_NEAR(fromFloor, 6 * g, 1e-6);
}

TYPED_TEST(MovingBody, FreeWallTakesTheMomentumOfAGrain)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.add(up<D>(), up<D>(-2), 1, 1);
    addMovingFloor<D>(scene.walls);
    nscd::WallBody<D> plate;
    plate.mass = 3;
    auto dynamics = withBodies<D>(scene, {plate});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], -0.5, 1e-12);
    EXPECT_NEAR(dynamics.wallBodies()[0].velocity[D - 1], -0.5, 1e-12);
}

TYPED_TEST(MovingBody, RodRestsFlatOnTheFloor)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene = rod<D>(0.3, up<D>(1.0));
    scene.addFloor();
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 200; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
    }
    EXPECT_NEAR(dynamics.grains().velocity[0].norm(), 0, 1e-10);
    EXPECT_NEAR(dynamics.grains().spin[0].norm(), 0, 1e-10);
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1, 1e-6);
}

TYPED_TEST(MovingBody, RodOnAnInclineSticksUpToTheFrictionCoefficient)
{
    constexpr int D = TestFixture::dimension;
    const double slope = 0.3;
    for (const double factor : {0.99, 1.01})
    {
        const double mu = factor * std::tan(slope);
        Scene<D> scene = rod<D>(mu, up<D>(1.0));
        scene.addFloor();
        auto dynamics = scene.dynamics();
        for (int i = 0; i < 50; ++i)
        {
            fall<D>(dynamics, inclined<D>(slope), dt);
        }
        const double expected = std::max(0.0, g * (std::sin(slope) - mu * std::cos(slope)) * 50 * dt);
        EXPECT_NEAR(dynamics.grains().velocity[0][0], expected, 1e-8);
    }
}

TYPED_TEST(MovingBody, RodStruckAtItsEndTurns)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene = rod<D>(0, nscd::Vector<D>::Zero());
    scene.add(nscd::Vector<D>::UnitX() + up<D>(2), up<D>(-1), 1, 1);
    auto dynamics = scene.dynamics();
    const double inertia = 4 * scene.grains.clusters[0].inertia[D == 2 ? 0 : 1];   // m R^2 times that of the shape
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    const double impulse = 1 / (1 + 1 + 1 / inertia);   // the contact, 1 m from the centre, closes with 1 m/s
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], -impulse, 1e-9);
    EXPECT_NEAR(dynamics.grains().velocity[1][D - 1], impulse - 1, 1e-9);
    EXPECT_NEAR(std::abs(dynamics.grains().spin[0][D == 2 ? 0 : 1]), impulse / inertia, 1e-9);
}

TYPED_TEST(MovingBody, GrainsCollideAcrossAPeriodicBoundary)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.settings.period[0] = 20;
    scene.add(1.5 * nscd::Vector<D>::UnitX(), -nscd::Vector<D>::UnitX());
    scene.add(18.5 * nscd::Vector<D>::UnitX(), nscd::Vector<D>::UnitX());
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 700; ++i)
    {
        fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    }
    EXPECT_NEAR(dynamics.grains().velocity[0].norm(), 0, 1e-10);
    EXPECT_NEAR(dynamics.grains().position[0][0] + 20 - dynamics.grains().position[1][0], 2, 1e-9);
}

TYPED_TEST(MovingBody, FloorOfAPeriodicBoxCarriesAGrainThatRollsOnForEver)
{
    constexpr int D = TestFixture::dimension;
    for (const double drift : {0.0, 3.0})
    {
        Scene<D> scene(0.3);
        scene.settings.period[0] = 10;
        if constexpr (D == 2)
        {
            scene.walls.push_back({{0, 0}, {10, 0}, 1, 0});
        }
        else
        {
            addMovingFloor<3>(scene.walls);   // longer than the period
        }
        scene.add(up<D>() + 2 * nscd::Vector<D>::UnitX(), 30 * nscd::Vector<D>::UnitX());
        auto dynamics = withBodies<D>(scene, {{}});
        dynamics.setWallMotion(0, -drift * nscd::Vector<D>::UnitX(), nscd::Spin<D>::Zero());
        for (int i = 0; i < 1500; ++i)
        {
            fall<D>(dynamics, up<D>(-g), 1e-2);
            ASSERT_NEAR(dynamics.grains().position[0][D - 1], 1, 1e-9) << "step " << i;
        }
        const double k = nscd::inertiaFactor<D>;
        EXPECT_NEAR(dynamics.grains().velocity[0][0], (30 - k * drift) / (1 + k), 0.02 * 30);
        EXPECT_GT(dynamics.grains().position[0][0], 200);
    }
}

TYPED_TEST(MovingBody, WallNearThePeriodicBoundaryIsMetFromTheOtherSide)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.settings.period[0] = 10;
    if constexpr (D == 2)
    {
        scene.walls.push_back({{9.5, -5}, {9.5, 5}, 1});
    }
    else
    {
        scene.walls.push_back(nscd::Triangle{{9.5, -9, -5}, {9.5, 9, -5}, {9.5, 0, 9}, 1});
    }
    scene.add(3 * nscd::Vector<D>::UnitX(), -nscd::Vector<D>::UnitX());
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 400; ++i)
    {
        fall<D>(dynamics, nscd::Vector<D>::Zero(), 1e-2);
    }
    EXPECT_NEAR(dynamics.grains().position[0][0], 0.5, 1e-9);
    EXPECT_NEAR(dynamics.grains().velocity[0].norm(), 0, 1e-9);
}

TYPED_TEST(MovingBody, ClusterStruckAtItsMiddleMemberTurnsWithItsOwnInertia)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.3);
    const nscd::Vector<D> x = nscd::Vector<D>::UnitX();
    const nscd::Vector<D> none = nscd::Vector<D>::Zero();
    scene.grains.clusters.push_back(nscd::makeCluster<D>({none, 1.5 * x, -1.5 * x}, {1, 1, 1}));
    scene.add(none, none, 2.5);
    scene.grains.shape[0] = 0;
    scene.add(up<D>(2), 0.1 * x - up<D>());
    auto dynamics = scene.dynamics();
    fall<D>(dynamics, none, dt);
    // At the contact, 1 m above the centre, the tangential impulse stops the slip of 0.1 m/s
    const double inertia = 2.5 * 2.5 * scene.grains.clusters[0].inertia[D == 2 ? 0 : 1];
    const double impulse = 0.1 / (1 + 1 / nscd::inertiaFactor<D> + 1 + 1 / inertia);
    EXPECT_NEAR(dynamics.grains().velocity[0][0], impulse, 1e-9);
    EXPECT_NEAR(std::abs(dynamics.grains().spin[0][D == 2 ? 0 : 1]), impulse / inertia, 1e-9);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], -0.5, 1e-9);
}

TYPED_TEST(MovingBody, WorkOfContactsIsTheEnergyThatGrainsAndFreeWallsLose)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.3);
    scene.add(up<D>() + nscd::Vector<D>::UnitX(), 0.3 * nscd::Vector<D>::UnitX() - up<D>());
    addMovingFloor<D>(scene.walls);
    nscd::WallBody<D> plate;
    plate.mass = 3;
    plate.inertia = nscd::Spin<D>::Constant(5);
    plate.velocity = up<D>(2);
    auto dynamics = withBodies<D>(scene, {plate});
    const auto energy = [&]
    {
        const auto& wall = dynamics.wallBodies()[0];
        return kineticEnergy(dynamics.grains()) + 1.5 * wall.velocity.squaredNorm() + 2.5 * wall.spin.squaredNorm();
    };
    const double before = energy();
    const auto report = fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_NEAR(report.contactWork, energy() - before, 1e-12);
    EXPECT_LT(report.contactWork, -1);
    EXPECT_GT(dynamics.wallBodies()[0].spin.norm(), 0.1);
}

TEST(FreeRotation, OfAClusterConservesAngularMomentumAndEnergy)
{
    Scene<3> scene;
    scene.grains.clusters.push_back(nscd::makeCluster<3>({{0, 0, 0}, {1.5, 0, 0}, {0, 0.7, 0}}, {1, 1, 0.5}));
    scene.add({0, 0, 0}, {0, 0, 0}, 1);
    scene.grains.shape[0] = 0;
    scene.grains.spin[0] = {0.01, 2, 0.02};
    const nscd::Spin<3> moments = scene.grains.clusters[0].inertia;
    const auto momentum = [&](const nscd::Grains<3>& grains)
    {
        const Eigen::Matrix3d r = grains.orientation[0].toRotationMatrix();
        return nscd::Vector<3>(r * moments.asDiagonal() * r.transpose() * grains.spin[0]);
    };
    std::vector<nscd::Orientation<3>> ends;
    for (const double step : {4e-3, 2e-3, 1e-3})
    {
        auto dynamics = scene.dynamics();
        const nscd::Vector<3> start = momentum(dynamics.grains());
        const double energy = start.dot(dynamics.grains().spin[0]);
        for (int i = 0; i < std::lround(20 / step); ++i)
        {
            fall<3>(dynamics, nscd::Vector<3>::Zero(), step);
        }
        EXPECT_LT((momentum(dynamics.grains()) - start).norm(), 1e-12 * start.norm());
        EXPECT_NEAR(momentum(dynamics.grains()).dot(dynamics.grains().spin[0]) / energy, 1, 1e-12);
        ends.push_back(dynamics.grains().orientation[0]);
    }
    const double ofLongStep = ends[0].angularDistance(ends[2]), ofShortStep = ends[1].angularDistance(ends[2]);
    EXPECT_LT(ofLongStep, 1e-2);
    EXPECT_LT(ofShortStep, 0.25 * ofLongStep);   // second order: (4 - 1)/(16 - 1)
}

}  // namespace movingBodies
