// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The Delassus operator of rigid bodies against their equations of motion.

#include "Bodies.hpp"
#include "nscd/base/Random.hpp"

#include <gtest/gtest.h>

namespace
{

template <class V>
V random(nscd::Random& numbers)
{
    V v;
    for (double& x : v.reshaped())
    {
        x = numbers.uniform(-1, 1);
    }
    return v;
}

/// Bodies of random shape that touch at random places.
template <int D>
Bodies<D> randomBodies(nscd::Random& numbers)
{
    Bodies<D> b;
    for (int i = 0; i < 6; ++i)
    {
        b.addGrain(random<nscd::Vector<D>>(numbers), 1, numbers.uniform(0.5, 2));
        auto& body = b.bodies.back();
        const auto root = random<nscd::SpinMatrix<D>>(numbers);
        body.inverseInertia += root * root.transpose();
        body.velocity = random<nscd::Vector<D>>(numbers);
        body.spin = random<nscd::Spin<D>>(numbers);
    }
    for (int k = 0; k < 20; ++k)
    {
        const int first = static_cast<int>(numbers.uniform(0, 7));
        const int second = (first + 1 + static_cast<int>(numbers.uniform(0, 6))) % 7;
        const auto normal = random<nscd::Vector<D>>(numbers).normalized();
        b.contacts.push_back({first, second, random<nscd::Vector<D>>(numbers), normal, 0.1 * k, 0.3});
    }
    return b;
}

double cross(const nscd::Vector<2>& a, const nscd::Vector<2>& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Velocity of a body's point.
nscd::Vector<2> velocityAt(const nscd::RigidBody<2>& b, const nscd::Vector<2>& x)
{
    const nscd::Vector<2> arm = x - b.position;
    return b.velocity + b.spin[0] * nscd::Vector<2>(-arm.y(), arm.x());
}

nscd::Vector<3> velocityAt(const nscd::RigidBody<3>& b, const nscd::Vector<3>& x)
{
    return b.velocity + b.spin.cross(x - b.position);
}

nscd::Spin<2> torque(const nscd::Vector<2>& arm, const nscd::Vector<2>& impulse)
{
    return nscd::Spin<2>(cross(arm, impulse));
}

nscd::Spin<3> torque(const nscd::Vector<3>& arm, const nscd::Vector<3>& impulse)
{
    return arm.cross(impulse);
}

template <class N>
class Delassus : public testing::Test
{
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Delassus, Dimensions);

TYPED_TEST(Delassus, FrameIsARotationThatBeginsWithTheNormal)
{
    constexpr int D = TypeParam::value;
    nscd::Random numbers(1);
    for (int i = 0; i < 100; ++i)
    {
        const auto n = random<nscd::Vector<D>>(numbers).normalized();
        const nscd::Block<D> frame = nscd::contactFrame(n);
        EXPECT_EQ(frame.col(0), n);
        EXPECT_TRUE(frame.isUnitary(1e-14));
        EXPECT_NEAR(frame.determinant(), 1, 1e-14);
    }
}

TYPED_TEST(Delassus, GivesTheRelativeVelocitiesAfterTheImpulses)
{
    constexpr int D = TypeParam::value;
    nscd::Random numbers(2);
    const Bodies<D> b = randomBodies<D>(numbers);
    const nscd::SparseProblem<D> problem = b.problem();
    nscd::Vectors<D> r;
    auto bodies = b.bodies;
    for (const auto& c : b.contacts)
    {
        r.push_back(random<nscd::Vector<D>>(numbers));
        const nscd::Vector<D> impulse = nscd::contactFrame(c.normal) * r.back();
        for (const auto& [i, sign] : {std::pair(c.first, -1.0), std::pair(c.second, 1.0)})
        {
            auto& body = bodies[i];
            body.velocity += sign * body.inverseMass * impulse;
            body.spin += sign * body.inverseInertia * torque(c.point - body.position, impulse);
        }
    }
    const auto moved = nscd::withImpulses<D>(b.bodies, b.contacts, r);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        EXPECT_LE((moved[i].velocity - bodies[i].velocity).norm(), 1e-13);
        EXPECT_LE((moved[i].spin - bodies[i].spin).norm(), 1e-13);
    }
    const nscd::Vectors<D> u = problem.velocities(r);
    for (std::size_t k = 0; k < u.size(); ++k)
    {
        const auto& c = b.contacts[k];
        const nscd::Vector<D> relative = velocityAt(bodies[c.second], c.point) - velocityAt(bodies[c.first], c.point);
        const nscd::Vector<D> expected =
            nscd::contactFrame(c.normal).transpose() * relative + c.approach * nscd::Vector<D>::Unit(0);
        EXPECT_LE((u[k] - expected).norm(), 1e-12);
    }
}

TYPED_TEST(Delassus, OfTwoGrainsIsDiagonal)
{
    constexpr int D = TypeParam::value;
    Bodies<D> b;
    nscd::Vector<D> along = nscd::Vector<D>::Constant(1);
    along *= 3 / along.norm();
    b.addGrain(nscd::Vector<D>::Zero(), 1, 2);
    b.addGrain(along, 2, 5);
    b.touch(1, 2, 0.3);
    b.contacts[0].point = along / 3;
    nscd::Block<D> expected = (1 + 1 / nscd::inertiaFactor<D>)*(1 / 2.0 + 1 / 5.0) * nscd::Block<D>::Identity();
    expected(0, 0) = 1 / 2.0 + 1 / 5.0;
    EXPECT_LE((b.problem().own(0) - expected).norm(), 1e-14);
}

TYPED_TEST(Delassus, HasBlocksOnlyBetweenContactsOfTheSameMovingBody)
{
    constexpr int D = TypeParam::value;
    Bodies<D> b;
    for (int i = 0; i < 3; ++i)
    {
        b.addGrain(2 * i * nscd::Vector<D>::Unit(D - 1) + nscd::Vector<D>::Unit(D - 1));
    }
    b.touchGround(1, nscd::Vector<D>::Zero(), 0.3);
    b.touch(1, 2, 0.3);
    b.touch(2, 3, 0.3);
    b.touchGround(3, nscd::Vector<D>::Unit(0), 0.3);
    // Ground contacts 0 and 3 do not see each other; 0-1, 1-2 and 2-3 do
    EXPECT_EQ(b.problem().blocks(), 4u + 2 * 3u);
}

TYPED_TEST(Delassus, RefusesBodiesThatAreNotThere)
{
    constexpr int D = TypeParam::value;
    Bodies<D> b;
    b.addGrain(nscd::Vector<D>::Zero());
    b.contacts.push_back({0, 2, nscd::Vector<D>::Zero(), nscd::Vector<D>::Unit(0), 0, 0});
    EXPECT_THROW(b.problem(), std::invalid_argument);
    b.contacts[0].second = 0;
    EXPECT_THROW(b.problem(), std::invalid_argument);
}

}  // namespace
