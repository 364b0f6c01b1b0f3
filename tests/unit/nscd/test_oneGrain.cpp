// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact motions of one disc or sphere on a floor; g = 9.81, unit mass and radius, no restitution.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace oneGrain
{

constexpr double dt = 1e-3;

template <class T>
class OneGrain : public testing::Test
{
public:
    static constexpr int dimension = T::value;

    /// A grain that touches the floor.
    static Scene<T::value> onFloor(double friction, double velocity = 0)
    {
        constexpr int D = dimension;
        Scene<D> scene(friction);
        scene.addFloor();
        scene.add(up<D>(), velocity * nscd::Vector<D>::UnitX());
        return scene;
    }

    static double velocityOnIncline(double friction, double angle, int steps)
    {
        constexpr int D = dimension;
        auto dynamics = onFloor(friction).dynamics();
        for (int i = 0; i < steps; ++i)
        {
            fall<D>(dynamics, inclined<D>(angle), dt);
        }
        return dynamics.grains().velocity[0].x();
    }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(OneGrain, Dimensions);

const double slope = M_PI / 6;

TYPED_TEST(OneGrain, RollsDownAnInclineWithTheInertiaOfASolidBody)
{
    constexpr int D = TestFixture::dimension;
    const double acceleration = g * std::sin(slope) / (1 + nscd::inertiaFactor<D>);
    EXPECT_NEAR(this->velocityOnIncline(1, slope, 100), acceleration * 100 * dt, 1e-10);
}

TYPED_TEST(OneGrain, SlipsOnAnInclineBelowTheThresholdOfFrictionOnly)
{
    constexpr int D = TestFixture::dimension;
    constexpr double k = nscd::inertiaFactor<D>;
    const double threshold = std::tan(slope) * k / (1 + k);   // tan/3 for a disc, 2 tan/7 for a sphere
    const double rolling = g * std::sin(slope) / (1 + k) * 100 * dt;
    EXPECT_NEAR(this->velocityOnIncline(1.01 * threshold, slope, 100), rolling, 1e-10);
    const double mu = 0.99 * threshold;
    EXPECT_NEAR(this->velocityOnIncline(mu, slope, 100), g * (std::sin(slope) - mu * std::cos(slope)) * 100 * dt,
                1e-10);
}

TYPED_TEST(OneGrain, SlidesWithoutSpinningWhenThereIsNoFriction)
{
    EXPECT_NEAR(this->velocityOnIncline(0, slope, 100), g * std::sin(slope) * 100 * dt, 1e-10);
}

TYPED_TEST(OneGrain, SlidesAndThenRolls)
{
    constexpr int D = TestFixture::dimension;
    constexpr double k = nscd::inertiaFactor<D>;
    const double mu = 0.3;
    auto dynamics = this->onFloor(mu, 1).dynamics();
    double rollsFrom = 0;
    for (int i = 1; i <= 200; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
        const double v = dynamics.grains().velocity[0].x();
        if (rollsFrom == 0 && std::abs(v - rollingVelocity(dynamics.grains(), 0)) < 1e-9)
        {
            rollsFrom = i * dt;
        }
    }
    EXPECT_NEAR(dynamics.grains().velocity[0].x(), 1 / (1 + k), 1e-10);
    EXPECT_NEAR(rollsFrom, k / (1 + k) / (mu * g), dt);
    EXPECT_NEAR(kineticEnergy(dynamics.grains()), 0.5 / (1 + k), 1e-10);   // loses k/(1+k): 1/3 or 2/7
}

TYPED_TEST(OneGrain, DroppedSpinningTakesOff)
{
    constexpr int D = TestFixture::dimension;
    constexpr double k = nscd::inertiaFactor<D>;
    Scene<D> scene = this->onFloor(0.3);
    scene.grains.spin[0].setZero();
    if constexpr (D == 2)
    {
        scene.grains.spin[0][0] = -1;
    }
    else
    {
        scene.grains.spin[0][1] = 1;
    }
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 300; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
    }
    EXPECT_NEAR(dynamics.grains().velocity[0].x(), k / (1 + k), 1e-10);
}

TYPED_TEST(OneGrain, HitsAWallObliquely)
{
    constexpr int D = TestFixture::dimension;
    constexpr double k = nscd::inertiaFactor<D>;
    const double mu = 0.3;
    for (const double tangential : {0.5, 2.0})
    {
        Scene<D> scene = this->onFloor(mu, tangential);
        scene.grains.velocity[0] -= up<D>();
        auto dynamics = scene.dynamics();
        fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
        const double impulse = std::min(mu, tangential * k / (1 + k));   // slips, or ends up rolling
        EXPECT_NEAR(dynamics.grains().velocity[0].x(), tangential - impulse, 1e-12);
        EXPECT_NEAR(rollingVelocity(dynamics.grains(), 0), impulse / k, 1e-12);
        EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0, 1e-12);
        EXPECT_NEAR(dynamics.contactImpulse()[0][0], -impulse, 1e-12);
        EXPECT_NEAR(dynamics.contactImpulse()[0][D - 1], 1, 1e-12);
        EXPECT_NEAR(dynamics.contactSpinImpulse()[0].norm(), impulse, 1e-12);
    }
}

TYPED_TEST(OneGrain, FallsFreelyAndLandsWithoutGoingThrough)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.addFloor();
    scene.add(up<D>(2.5));
    auto dynamics = scene.dynamics();
    double t = 0;
    for (; t < 1; t += 1e-2)
    {
        fall<D>(dynamics, up<D>(-g), 1e-2);
        EXPECT_LE(dynamics.worstOverlap(), 1e-11);   // the tolerance and round-off
    }
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1, 1e-11);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0, 1e-10);
}

TYPED_TEST(OneGrain, IsDividedIntoSubStepsWhenFast)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.addFloor();
    scene.add(up<D>(3), up<D>(-6.9 / dt));   // 6.9 radii a step, one of which per sub-step
    auto dynamics = scene.dynamics();
    const nscd::StepReport report = fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_EQ(report.subSteps, 7);
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1, 1e-9);
    EXPECT_NEAR(dynamics.contactImpulse()[0][D - 1], 6.9 / dt, 1e-9 / dt);
    EXPECT_EQ(dynamics.lastTimeStep(), dt);
}

TYPED_TEST(OneGrain, ObeysForceAndTorqueWithoutContacts)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.add(nscd::Vector<D>::Zero(), nscd::Vector<D>::Zero(), 0.5, 3);
    auto dynamics = scene.dynamics();
    dynamics.step({nscd::Vector<D>::UnitX() * 6}, {nscd::Spin<D>::Constant(1.5)}, 0.1);
    EXPECT_DOUBLE_EQ(dynamics.grains().velocity[0].x(), 0.2);
    EXPECT_DOUBLE_EQ(dynamics.grains().position[0].x(), 0.02);
    EXPECT_DOUBLE_EQ(dynamics.grains().spin[0][0], 0.15 / (nscd::inertiaFactor<D> * 3 * 0.25));
    EXPECT_EQ(dynamics.contactImpulse()[0].norm(), 0);
    EXPECT_EQ(dynamics.contactSpinImpulse()[0].norm(), 0);
}

}  // namespace oneGrain
