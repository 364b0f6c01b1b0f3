// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Restitution, rolling resistance and cohesion against their exact thresholds.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace
{

constexpr double dt = 1e-3;

template <class T>
class ContactLaw : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ContactLaw, Dimensions);

template <int D>
nscd::StepReport pull(nscd::ContactDynamics<D>& dynamics, const nscd::Vector<D>& force, double step = dt)
{
    const std::size_t n = dynamics.grains().size();
    nscd::Vectors<D> forces(n, nscd::Vector<D>::Zero());
    forces.back() = force;
    return dynamics.step(forces, nscd::Spins<D>(n, nscd::Spin<D>::Zero()), step);
}

/// Two grains that touch, the first one very heavy, with a contact law between them.
template <int D>
Scene<D> pair(const nscd::ContactParameters& law)
{
    Scene<D> scene;
    scene.table.set(0, 0, law);
    scene.add(nscd::Vector<D>::Zero(), nscd::Vector<D>::Zero(), 1, 1e12);
    scene.add(up<D>(2));
    return scene;
}

}  // namespace

TYPED_TEST(ContactLaw, GrainBouncesWithTheCoefficientOfRestitution)
{
    constexpr int D = TestFixture::dimension;
    for (const double e : {0.0, 0.3, 1.0})
    {
        Scene<D> scene;
        scene.addFloor();
        scene.table.set(0, 1, {0, e});
        scene.add(up<D>(), up<D>(-2));
        auto dynamics = scene.dynamics();
        pull<D>(dynamics, nscd::Vector<D>::Zero());
        EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 2 * e, 1e-12);
    }
}

TYPED_TEST(ContactLaw, EqualGrainsExchangeVelocitiesInAnElasticCollision)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.table.set(0, 0, {0, 1});
    scene.add(nscd::Vector<D>::Zero(), nscd::Vector<D>::UnitX());
    scene.add(2.0005 * nscd::Vector<D>::UnitX());
    auto dynamics = scene.dynamics();
    const auto report = pull<D>(dynamics, nscd::Vector<D>::Zero());
    EXPECT_NEAR(dynamics.grains().velocity[0][0], 0, 1e-12);
    EXPECT_NEAR(dynamics.grains().velocity[1][0], 1, 1e-12);
    EXPECT_NEAR(report.contactWork, 0, 1e-12);
}

TYPED_TEST(ContactLaw, BouncingGrainLosesTheHeightItShould)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene;
    scene.addFloor();
    scene.table.set(0, 1, {0, 0.5});
    scene.add(up<D>(2));
    auto dynamics = scene.dynamics();
    double highest = 0;
    bool hit = false;
    for (int i = 0; i < 9000; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 1e-4);
        hit = hit || dynamics.grains().velocity[0][D - 1] > 0;
        highest = hit ? std::max(highest, dynamics.grains().position[0][D - 1] - 1) : 0;
    }
    EXPECT_NEAR(highest, 0.25, 2e-3);   // e^2 H, to first order in dt: H = 1, falls with 4.4 m/s
    for (int i = 0; i < 12000; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 1e-4);
    }
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1, 1e-4);   // at rest, a bounce of less than one step's way
}

TYPED_TEST(ContactLaw, RollingResistanceHoldsAGrainOnASlopeUpToItsCoefficient)
{
    constexpr int D = TestFixture::dimension;
    const double slope = 0.2;
    for (const double factor : {0.99, 1.01})
    {
        Scene<D> scene;
        scene.addFloor();
        nscd::ContactParameters law;
        law.friction = 1;
        law.rolling = factor * std::tan(slope);   // moment m g sin r against rolling m g cos r
        scene.table.set(0, 1, law);
        scene.add(up<D>());
        auto dynamics = scene.dynamics();
        for (int i = 0; i < 100; ++i)
        {
            fall<D>(dynamics, inclined<D>(slope), dt);
        }
        // below the threshold the part of the weight's moment that is not resisted accelerates it
        const double expected =
            std::max(0.0, g * (std::sin(slope) - law.rolling * std::cos(slope)) / (1 + nscd::inertiaFactor<D>));
        EXPECT_NEAR(dynamics.grains().velocity[0][0], expected * 100 * dt, 1e-9);
        EXPECT_NEAR(rollingVelocity(dynamics.grains(), 0), expected * 100 * dt, 1e-9);
    }
}

TYPED_TEST(ContactLaw, CohesionHoldsUpToItsForce)
{
    constexpr int D = TestFixture::dimension;
    for (const double factor : {0.99, 1.01})
    {
        nscd::ContactParameters law;
        law.cohesion = 3;
        law.tension = 4;   // with R = 1/2: 2 N more
        auto dynamics = pair<D>(law).dynamics();
        pull<D>(dynamics, up<D>(-1));   // makes the contact
        for (int i = 0; i < 100; ++i)
        {
            pull<D>(dynamics, up<D>(5 * factor));
        }
        EXPECT_NEAR(dynamics.grains().velocity[1][D - 1], factor < 1 ? 0 : 5 * factor * 100 * dt, 0.06);
        EXPECT_EQ(dynamics.grains().velocity[1].norm() < 1e-12, factor < 1);
    }
}

TYPED_TEST(ContactLaw, CohesionIsPartOfTheForcesOfTheStepInWhichItEnds)
{
    constexpr int D = TestFixture::dimension;
    for (const double rolling : {0.0, 0.1})
    {
        nscd::ContactParameters law;
        law.cohesion = 3;
        law.rolling = rolling;
        auto dynamics = pair<D>(law).dynamics();
        pull<D>(dynamics, up<D>(-1));
        pull<D>(dynamics, up<D>(4));
        ASSERT_EQ(dynamics.contacts().size(), 1u);
        const nscd::ContactForce<D> c = dynamics.contacts()[0];
        const nscd::Vector<D> given = dynamics.contactImpulse()[1] / dt;
        EXPECT_NEAR(given[D - 1], -3, 1e-9);
        EXPECT_LE(((c.second == 1 ? c.force : nscd::Vector<D>(-c.force)) - given).norm(), 1e-9);
        EXPECT_EQ(c.pressing, 0);
        pull<D>(dynamics, up<D>(4));
        EXPECT_TRUE(dynamics.contacts().empty());
    }
}

TYPED_TEST(ContactLaw, CohesionActsAfterItsDelayOnly)
{
    constexpr int D = TestFixture::dimension;
    nscd::ContactParameters law;
    law.cohesion = 5;
    law.cohesionDelay = 10.5 * dt;
    for (const int steps : {10, 12})
    {
        auto dynamics = pair<D>(law).dynamics();
        for (int i = 0; i < steps; ++i)
        {
            pull<D>(dynamics, up<D>(-1));
        }
        pull<D>(dynamics, up<D>(4));
        EXPECT_EQ(dynamics.grains().velocity[1][D - 1] > 1e-9, steps < 11);
    }
}

TYPED_TEST(ContactLaw, CohesionActsWhereItsAmbientValueIsSmall)
{
    constexpr int D = TestFixture::dimension;
    nscd::ContactParameters law;
    law.cohesion = 5;
    law.cohesionBelow = 0.9;
    for (const double other : {0.79, 0.81})   // a mean of 0.895 and of 0.905
    {
        auto dynamics = pair<D>(law).dynamics();
        pull<D>(dynamics, up<D>(-1));
        dynamics.setAmbient({1, other});
        pull<D>(dynamics, up<D>(4));
        EXPECT_EQ(dynamics.grains().velocity[1][D - 1] > 1e-9, other > 0.8);
    }
}

TYPED_TEST(ContactLaw, CohesionAddsToTheForceThatFrictionScalesWith)
{
    constexpr int D = TestFixture::dimension;
    for (const double factor : {0.99, 1.01})
    {
        nscd::ContactParameters law;
        law.friction = 0.5;
        law.cohesion = 4;
        law.rolling = 100;   // nothing rolls
        Scene<D> scene;
        scene.addFloor();
        scene.table.set(0, 1, law);
        scene.add(up<D>());
        auto dynamics = scene.dynamics();
        fall<D>(dynamics, up<D>(-g), dt);
        pull<D>(dynamics, factor * 0.5 * (4 + 1) * nscd::Vector<D>::UnitX() - up<D>(1));
        EXPECT_EQ(dynamics.grains().velocity[0][0] > 1e-9, factor > 1);
    }
}
