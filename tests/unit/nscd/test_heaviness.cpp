// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Grains that something moves with: what contacts give to it, and when the grain gets it.

#include "Messages.hpp"
#include "Scene.hpp"

#include <cstdio>
#include <gtest/gtest.h>
#include <unistd.h>

namespace heaviness
{

constexpr double dt = 1e-3;

template <class T>
class Heaviness : public testing::Test
{
public:
    static constexpr int dimension = T::value;

    /// Of what moves with a grain, which only its inertia holds back, under a load on the grain.
    static nscd::Vector<T::value> reaction(const nscd::ContactDynamics<T::value>& dynamics, int i, double heaviness,
                                           const nscd::Vector<T::value>& load)
    {
        return -dynamics.owed().force[i] / dt - (1 - 1 / heaviness) * (load + dynamics.lasting().force[i]);
    }
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Heaviness, Dimensions);

TYPED_TEST(Heaviness, ReboundIsThatOfTheGrainAndOfWhatMovesWithIt)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0, 0.8);
    scene.addFloor();
    scene.add(up<D>(1.0005), up<D>(-1));
    auto dynamics = scene.dynamics();
    dynamics.setHeaviness({3});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0.8, 1e-12);
    EXPECT_NEAR(dynamics.contactImpulse()[0][D - 1], 3 * 1.8, 1e-12);
    EXPECT_NEAR(dynamics.owed().force[0][D - 1], 2 * 1.8, 1e-12);

    // It is turned round by the grain in the next step, and by the contact in the end
    dynamics.setHeaviness({3});
    const nscd::Vector<D> none = nscd::Vector<D>::Zero();
    dynamics.step({this->reaction(dynamics, 0, 3, none)}, {nscd::Spin<D>::Zero()}, dt);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0.8, 1e-12);
    EXPECT_EQ(dynamics.owed().force[0].norm(), 0);
}

TYPED_TEST(Heaviness, WhatHoldsAGrainIsExpectedOnceItHasDoneSoForThreeSteps)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0);
    scene.addFloor();
    scene.add(up<D>(1), nscd::Vector<D>::Zero());
    auto dynamics = scene.dynamics();
    for (int step = 0; step < 6; ++step)
    {
        fall<D>(dynamics, up<D>(-10), dt);
        EXPECT_NEAR(dynamics.unexpected().force[0][D - 1], step < 3 ? 10 * dt : 0, 1e-12) << step;
    }
    fall<D>(dynamics, up<D>(10), dt);
    EXPECT_NEAR(dynamics.unexpected().force[0][D - 1], -10 * dt, 1e-12);
}

TYPED_TEST(Heaviness, MomentaAreKeptWithWhatIsOwed)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.3, 0.7);
    scene.add(nscd::Vector<D>::Zero(), nscd::Vector<D>::UnitX() + 0.3 * up<D>(), 1, 2);
    scene.add(2.0002 * nscd::Vector<D>::UnitX(), -nscd::Vector<D>::UnitX(), 1, 5);
    auto dynamics = scene.dynamics();
    const auto momentum = [&]
    {
        const nscd::Grains<D>& all = dynamics.grains();
        return nscd::Vector<D>(all.mass[0] * all.velocity[0] + all.mass[1] * all.velocity[1] +
                               dynamics.owed().force[0] + dynamics.owed().force[1]);
    };
    // About the origin: of one radius, friction gives both the same, and takes it from the velocities' part
    const auto spin = [&](int i)
    {
        const nscd::Grains<D>& all = dynamics.grains();
        return nscd::Spin<D>(nscd::inertiaFactor<D> * all.mass[i] * all.spin[i]);
    };
    const nscd::Vector<D> before = momentum();
    dynamics.setHeaviness({2, 1.2});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_GT(dynamics.owed().force[0].norm(), 0.1);
    EXPECT_LT((momentum() - before).norm(), 1e-12);
    // Both have the same angular impulse from friction
    EXPECT_GT(spin(0).norm(), 0.01);
    EXPECT_LT((spin(0) - spin(1)).norm(), 1e-12);
    EXPECT_EQ(dynamics.owed().torque[0].norm(), 0);

    // Without a fluid that takes it, the grains have it after the next step
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_EQ(dynamics.owed().force[0].norm(), 0);
    EXPECT_LT((momentum() - before).norm(), 1e-12);
    EXPECT_LT((spin(0) - spin(1)).norm(), 1e-12);
}

TYPED_TEST(Heaviness, IsNotFeltByWhatIsHeld)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.4);
    scene.addFloor();
    scene.add(up<D>(1));
    scene.add(up<D>(3), nscd::Vector<D>::Zero(), 1, 4);
    auto dynamics = scene.dynamics();
    // Bounds are those of sweeps to 1e-13/dt
    const std::vector<double> heaviness{4, 1.5};
    for (int step = 0; step < 20; ++step)
    {
        nscd::Vectors<D> force;
        for (int i = 0; i < 2; ++i)
        {
            const nscd::Vector<D> load = dynamics.grains().mass[i] * up<D>(-g);
            force.push_back(load + this->reaction(dynamics, i, heaviness[i], load));
        }
        dynamics.setHeaviness(heaviness);
        dynamics.step(force, {nscd::Spin<D>::Zero(), nscd::Spin<D>::Zero()}, dt);

        const double weight = g * dt;
        EXPECT_NEAR(dynamics.contactImpulse()[0][D - 1], weight, 1e-7 * weight);
        EXPECT_NEAR(dynamics.contactImpulse()[1][D - 1], 4 * weight, 1e-7 * weight);
        EXPECT_LT(dynamics.grains().velocity[1].norm(), 1e-7 * weight);
    }
    EXPECT_LT(dynamics.owed().force[1].norm(), 1e-7 * g * dt);
}

TYPED_TEST(Heaviness, WhatIsOwedIsPartOfTheState)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0.3, 0.8);
    scene.addFloor();
    scene.add(up<D>(1.0005), 0.2 * nscd::Vector<D>::UnitX() - up<D>(1));
    auto dynamics = scene.dynamics();
    dynamics.setHeaviness({3});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    const std::string file = testing::TempDir() + "nscd_owed_" + std::to_string(::getpid()) + ".h5";
    dynamics.save(file, dt);
    auto continued = scene.dynamics();
    continued.load(file);
    std::remove(file.c_str());
    EXPECT_GT(continued.owed().force[0].norm(), 1);
    EXPECT_TRUE(sameBits(dynamics, continued));
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    fall<D>(continued, nscd::Vector<D>::Zero(), dt);
    EXPECT_TRUE(sameBits(dynamics, continued));
}

TYPED_TEST(Heaviness, BelowOneOrOfOtherGrainsIsRefused)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.add(up<D>(1));
    auto dynamics = scene.dynamics();
    EXPECT_EQ(invalid([&] { dynamics.setHeaviness({1, 1}); }), "1 grains but the heaviness of 2");
    EXPECT_EQ(invalid([&] { dynamics.setHeaviness({0.5}); }),
              "grain 100: heaviness 0.500000 is not finite and at least 1");
}

}  // namespace heaviness
