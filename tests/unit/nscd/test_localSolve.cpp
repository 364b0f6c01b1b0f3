// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One contact with coupled normal and tangential directions.

#include "nscd/base/Random.hpp"
#include "nscd/contact/Contact.hpp"
#include "nscd/contact/LocalSolve.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace
{

using nscd::Block;
using nscd::Vector;

/// Nearest point of the cone |T| <= mu N.
template <int D>
Vector<D> onCone(Vector<D> x, double mu)
{
    const double length = x.template tail<D - 1>().norm();
    if (length <= mu * x[0])
    {
        return x;
    }
    const double normal = std::max(0.0, (x[0] + mu * length) / (1 + mu * mu));
    x[0] = normal;
    x.template tail<D - 1>() *= mu * normal / length;
    return x;
}

/// Natural-map residual of the impulse r as a velocity, over |q| + |W| |r|; rounding alone makes it some 1e-16.
template <int D>
double violation(const Block<D>& W, const Vector<D>& q, double mu, const Vector<D>& r)
{
    Vector<D> u = W * r + q;
    u[0] += mu * u.template tail<D - 1>().norm();
    const Vector<D> x = W(0, 0) * r;
    return (x - onCone<D>(x - u, mu)).norm() / (q.norm() + W.norm() * r.norm());
}

template <int D>
Vector<D> randomVector(nscd::Random& random)
{
    Vector<D> v;
    for (double& x : v)
    {
        x = random.uniform(-1, 1);
    }
    return v;
}

/// Positive definite: masses and lever arms of two bodies, in random proportions.
template <int D>
Block<D> randomOperator(nscd::Random& random)
{
    Block<D> W = std::pow(10, random.uniform(-3, 3)) * Block<D>::Identity();
    for (int k = 0; k < 3; ++k)
    {
        const Vector<D> h = std::pow(10, random.uniform(-2, 2)) * randomVector<D>(random);
        W += h * h.transpose();
    }
    return W;
}

template <class N>
class LocalSolve : public testing::Test
{
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(LocalSolve, Dimensions);

TYPED_TEST(LocalSolve, SatisfiesTheLawsForRandomOperators)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(1);
    int stuck = 0, slipping = 0, open = 0;
    double worst = 0;
    for (int i = 0; i < 100000; ++i)
    {
        const Block<D> W = randomOperator<D>(random);
        const Vector<D> q = randomVector<D>(random);
        const double mu = random.uniform(0, 2);
        const Vector<D> r = nscd::solveLocal<D>(W, q, mu);
        worst = std::max(worst, violation<D>(W, q, mu, r));
        const Vector<D> u = W * r + q;
        (r[0] == 0 ? open : u.template tail<D - 1>().norm() < 1e-10 ? stuck : slipping)++;
    }
    EXPECT_LE(worst, 1e-12);
    // Half of the contacts approach; both of the others occur in earnest
    EXPECT_NEAR(open, 50000, 1000);
    EXPECT_GT(stuck, 5000);
    EXPECT_GT(slipping, 5000);
}

TYPED_TEST(LocalSolve, SatisfiesTheLawsWhereWIsNotSymmetric)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(2);
    for (int i = 0; i < 10000; ++i)
    {
        Block<D> W = randomOperator<D>(random);
        for (int a = 0; a < D; ++a)
        {
            for (int b = 0; b < a; ++b)
            {
                // An antisymmetric part leaves x.Wx > 0 as it is
                const double gyroscopic = 0.3 * W.trace() * random.uniform(-1, 1);
                W(a, b) += gyroscopic;
                W(b, a) -= gyroscopic;
            }
        }
        const Vector<D> q = randomVector<D>(random);
        const double mu = random.uniform(0, 1);
        ASSERT_LE(violation<D>(W, q, mu, nscd::solveLocal<D>(W, q, mu)), 1e-12);
    }
}

TYPED_TEST(LocalSolve, EqualsTheClosedFormOfDiscsAndSpheres)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(3);
    for (int i = 0; i < 1000; ++i)
    {
        nscd::Body<D> bodies[2];
        for (auto& body : bodies)
        {
            body.velocity = randomVector<D>(random);
            body.surfaceSpeed = nscd::zeroTangent<D>();
            body.inverseMass = random.uniform(0.1, 10);
            body.inverseInertia = random.uniform(0.1, 30);
        }
        const double w = bodies[0].inverseMass + bodies[1].inverseMass;
        Block<D> W = Block<D>::Identity() * (w + bodies[0].inverseInertia + bodies[1].inverseInertia);
        W(0, 0) = w;
        nscd::Contact<D> contact{Vector<D>::Unit(0), 0, 1 / w, random.uniform(0, 1), 0, nscd::zeroTangent<D>(), 0, 1};
        const Vector<D> q = bodies[1].velocity - bodies[0].velocity;
        nscd::solve<D>(contact, bodies);
        const Vector<D> r = nscd::solveLocal<D>(W, q, contact.friction);
        const Vector<D> expected = nscd::impulseVector(contact.normal, contact.normalImpulse, contact.slipImpulse);
        ASSERT_LE((r - expected).norm(), 1e-14 * (1 + expected.norm())) << r << "\n\n" << expected;
    }
}

TYPED_TEST(LocalSolve, WithoutFrictionHasANormalImpulseAlone)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(4);
    const Block<D> W = randomOperator<D>(random);
    Vector<D> q = Vector<D>::Constant(0.5);
    q[0] = -2;
    const Vector<D> r = nscd::solveLocal<D>(W, q, 0);
    EXPECT_DOUBLE_EQ(r[0], 2 / W(0, 0));
    EXPECT_EQ(r.template tail<D - 1>().norm(), 0);
}

TYPED_TEST(LocalSolve, SmallFrictionIsTheLimitOfNone)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(5);
    for (const double mu : {1e-300, 1e-100, 1e-17, 1e-8})
    {
        const Block<D> W = randomOperator<D>(random);
        Vector<D> q = randomVector<D>(random);
        q[0] = -1;
        const Vector<D> r = nscd::solveLocal<D>(W, q, mu);
        EXPECT_LE(violation<D>(W, q, mu, r), 1e-12);
        EXPECT_NEAR(r[0] * W(0, 0), 1, 1e3 * mu + 1e-15);
    }
}

TYPED_TEST(LocalSolve, ScalesWithTheUnits)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(6);
    for (int i = 0; i < 100; ++i)
    {
        const Block<D> W = randomOperator<D>(random);
        Vector<D> q = randomVector<D>(random);
        q[0] = -std::abs(q[0]);
        const Vector<D> r = nscd::solveLocal<D>(W, q, 0.5);
        // Powers of two: no rounding but that of sums
        const Vector<D> other = nscd::solveLocal<D>(W * 0x1p40, q * 0x1p-30, 0.5);
        ASSERT_LE((other * 0x1p70 - r).norm(), 1e-12 * r.norm());
    }
}

TYPED_TEST(LocalSolve, TangentialDirectionsWithoutResponseSlideOn)
{
    constexpr int D = TypeParam::value;
    // Two bodies that the tangential impulse cannot move, e.g. with rotations and translations blocked
    Block<D> W = Block<D>::Zero();
    W(0, 0) = 2;
    Vector<D> q = Vector<D>::Constant(-0.5);
    q[0] = -1;
    const Vector<D> r = nscd::solveLocal<D>(W, q, 0.3);
    EXPECT_DOUBLE_EQ(r[0], 0.5);
    EXPECT_NEAR(r.template tail<D - 1>().norm(), 0.3 * 0.5, 1e-15);
    EXPECT_LT(r.template tail<D - 1>().dot(q.template tail<D - 1>()), 0);
    // Nothing slides: nothing is needed
    q.template tail<D - 1>().setZero();
    EXPECT_EQ(nscd::solveLocal<D>(W, q, 0.3), (Vector<D>(Vector<D>::Unit(0) * 0.5)));
}

TYPED_TEST(LocalSolve, SingularOrIndefiniteOperatorsGiveFiniteImpulsesThatSeparate)
{
    constexpr int D = TypeParam::value;
    nscd::Random random(7);
    for (int i = 0; i < 100000; ++i)
    {
        // Rank one, or symmetric with any tangential part
        const Vector<D> h = randomVector<D>(random);
        Block<D> W = h * h.transpose();
        if (i % 2 == 1)
        {
            W.template block<D - 1, D - 1>(1, 1).diagonal() += randomVector<D>(random).template tail<D - 1>();
        }
        W(0, 0) += 0.01;
        const Vector<D> q = randomVector<D>(random);
        const double mu = random.uniform(0, 3);
        const Vector<D> r = nscd::solveLocal<D>(W, q, mu);
        ASSERT_TRUE(r.allFinite());
        ASSERT_GE((W * r + q)[0], -1e-12 * (q.norm() + W.norm() * r.norm()));
        ASSERT_LE((r.template tail<D - 1>().norm()), mu * r[0] + 1e-12 * r.norm());
    }
}

/// Delassus operator of the lower end of a slender rod of unit mass and half length, inclined by 'angle', in the
/// plane that the rod and the first tangential direction span.
template <int D>
Block<D> rod(double angle)
{
    constexpr double inertia = 1.0 / 3;
    const double x = -std::cos(angle), y = -std::sin(angle);
    Block<D> W = Block<D>::Identity();
    W(0, 0) += x * x / inertia;
    W(1, 1) += y * y / inertia;
    W(0, 1) = W(1, 0) = -x * y / inertia;
    if constexpr (D == 3)
    {
        W(2, 2) += 1 / inertia;
    }
    return W;
}

TYPED_TEST(LocalSolve, RodOfPainleveJams)
{
    constexpr int D = TypeParam::value;
    for (const double angle : {0.6, std::atan(2.0), 1.3})
    {
        const Block<D> W = rod<D>(angle);
        const double critical = (std::tan(angle) + 4 / std::tan(angle)) / 3;
        EXPECT_NEAR(critical, W(0, 0) / std::abs(W(0, 1)), 1e-14);
        for (const double mu : {0.9 * critical, 1.1 * critical, 10 * critical})
        {
            // It slides one metre per second towards the side where friction presses it to the floor
            Vector<D> q = Vector<D>::Zero();
            q[0] = -1e-3;
            q[1] = W(0, 1) > 0 ? 1 : -1;
            const Vector<D> r = nscd::solveLocal<D>(W, q, mu);
            const Vector<D> u = W * r + q;
            EXPECT_TRUE(r.allFinite());
            EXPECT_GE(u[0], -1e-14);
            EXPECT_LE(violation<D>(W, q, mu, r), 1e-14);
            // Above the critical friction no sliding is possible: it stops at once, whatever the load
            if (mu > critical)
            {
                EXPECT_LE(u.norm(), 1e-14);
                EXPECT_GT(r[0], 0.1);
            }
            else
            {
                EXPECT_GT(u.norm(), 0.1);
            }
            // Without a load there are two solutions; the contact stays open
            q[0] = 1e-3;
            EXPECT_EQ(nscd::solveLocal<D>(W, q, mu).norm(), 0);
        }
    }
}

TEST(LocalSolveInSpace, RotatesWithTheTangentialFrame)
{
    nscd::Random random(8);
    for (int i = 0; i < 1000; ++i)
    {
        const Block<3> W = randomOperator<3>(random);
        Vector<3> q = randomVector<3>(random);
        q[0] = -std::abs(q[0]);
        const double mu = random.uniform(0, 0.5);
        const Block<3> turn(Eigen::AngleAxisd(random.uniform(0, 2 * M_PI), Vector<3>::Unit(0)));
        const Vector<3> r = nscd::solveLocal<3>(W, q, mu);
        const Vector<3> turned = nscd::solveLocal<3>(turn * W * turn.transpose(), turn * q, mu);
        // Velocities, as impulses amplify rounding by the condition of W, up to 1e10 here
        ASSERT_LE((W * (turn.transpose() * turned - r)).norm(), 1e-11 * (q.norm() + W.norm() * r.norm()));
    }
}

TEST(LocalSolveInSpace, InAPlaneEqualsTwoDimensions)
{
    nscd::Random random(9);
    for (int i = 0; i < 1000; ++i)
    {
        const Block<2> W = randomOperator<2>(random);
        const Vector<2> q = randomVector<2>(random);
        const double mu = random.uniform(0, 1);
        Block<3> space = Block<3>::Identity();
        space.topLeftCorner<2, 2>() = W;
        const Vector<2> r = nscd::solveLocal<2>(W, q, mu);
        const Vector<3> s = nscd::solveLocal<3>(space, {q[0], q[1], 0}, mu);
        ASSERT_LE((W * (s.head<2>() - r)).norm() + std::abs(s[2]), 1e-12 * (q.norm() + W.norm() * r.norm()));
    }
}

}  // namespace
