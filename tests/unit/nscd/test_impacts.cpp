// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Contacts with restitution: impacts at their own time and place within a step.

#include "Gas.hpp"
#include "RandomScene.hpp"
#include "nscd/impact/ImpactLaw.hpp"

#include <gtest/gtest.h>

namespace
{

template <class T>
class Impact : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Impact, Dimensions);

template <int D>
Scene<D> bouncing(double restitution, double friction = 0)
{
    Scene<D> scene;
    scene.table.set(0, 0, {friction, restitution});
    scene.table.set(0, 1, {friction, restitution});
    return scene;
}

template <int D>
nscd::Vector<D> inLine(double x)
{
    return x * nscd::Vector<D>::UnitX();
}

/// Velocities of equal bodies in a row after all impacts, one after the other from the left.
std::vector<double> afterAllImpacts(std::vector<double> v, double e)
{
    for (bool any = true; any;)
    {
        any = false;
        for (std::size_t i = 0; i + 1 < v.size(); ++i)
        {
            const double closing = v[i] - v[i + 1];
            if (closing > 0)
            {
                v[i] -= 0.5 * (1 + e) * closing;
                v[i + 1] += 0.5 * (1 + e) * closing;
                any = true;
            }
        }
    }
    return v;
}

}  // namespace

TYPED_TEST(Impact, InARowOfThreeIsPassedOnWithinTheStep)
{
    constexpr int D = TestFixture::dimension;
    const double e = 0.97, dt = 0.1;
    const std::vector<double> exact = afterAllImpacts({1, 0, 0}, e);
    for (const double gap : {0.05, 0.2, 0.6})   // of a step's way
    {
        Scene<D> scene = bouncing<D>(e);
        for (int i = 0; i < 3; ++i)
        {
            scene.add(inLine<D>(i * (2 + gap * dt)), inLine<D>(i == 0));
        }
        auto dynamics = scene.dynamics();
        for (int i = 0; i < 4000; ++i)   // the first meets the second again with 2e-4 of its velocity
        {
            fall<D>(dynamics, inLine<D>(0), dt);
        }
        for (int i = 0; i < 3; ++i)
        {
            EXPECT_NEAR(dynamics.grains().velocity[i][0], exact[i], 1e-12) << "gap " << gap << ", grain " << i;
        }
    }
}

TYPED_TEST(Impact, OnACradleLetsAsManyLeaveAsCome)
{
    constexpr int D = TestFixture::dimension;
    const double dt = 0.05;
    for (const double gap : {0.0, 1e-6, 1e-4})
    {
        for (const int come : {1, 2})
        {
            Scene<D> scene = bouncing<D>(1);
            for (int i = 0; i < 6; ++i)
            {
                scene.add(inLine<D>(i * (2 + gap) - (i < come ? 0.31 : 0)), inLine<D>(i < come));
            }
            auto dynamics = scene.dynamics();
            for (int i = 0; i < 40; ++i)
            {
                fall<D>(dynamics, inLine<D>(0), dt);
            }
            for (int i = 0; i < 6; ++i)
            {
                EXPECT_NEAR(dynamics.grains().velocity[i][0], i >= 6 - come, 1e-12) << gap << ", " << come << ", " << i;
            }
            EXPECT_NEAR(kineticEnergy<D>(dynamics.grains()), 0.5 * come, 1e-12);
        }
    }
}

TYPED_TEST(Impact, OfElasticGasLosesNoEnergy)
{
    constexpr int D = TestFixture::dimension;
    for (const double dt : {5e-3, 5e-4})
    {
        Gas<D> gas(D == 2 ? 10 : 5, 2.4, 11);
        gas.scene.table.set(0, 0, {0, 1});
        auto dynamics = gas.scene.dynamics();
        const double before = kineticEnergy<D>(dynamics.grains());
        std::size_t impacts = 0;
        bool apart = true;
        for (double t = 0; t < 1; t += dt)
        {
            const auto report = fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
            impacts += report.impacts;
            apart = apart && report.active == 0;
        }
        EXPECT_GT(impacts, dynamics.grains().size());
        EXPECT_NEAR(kineticEnergy<D>(dynamics.grains()), before, 1e-9 * before) << "dt " << dt;
    }
}

TYPED_TEST(Impact, OfAnyBodiesObeysCoulombAndGainsNoEnergy)
{
    constexpr int D = TestFixture::dimension;
    Draw draw(5);
    double least = 1;
    for (int i = 0; i < 10000; ++i)
    {
        Eigen::Matrix<double, D, D> a;
        for (int k = 0; k < D; ++k)
        {
            a.col(k) = draw.vector<D>(draw.scale(0.1, 3));
        }
        const nscd::Block<D> W = a.transpose() * a + 0.05 * nscd::Block<D>::Identity();
        nscd::Vector<D> u = draw.vector<D>(1);
        u[0] = -std::abs(u[0]) - 1e-3;
        const double mu = draw.pick({0.0, 0.1, 0.5, 2.0}), e = draw.pick({0.0, 0.5, 0.97, 1.0});
        const nscd::Vector<D> r = nscd::impactImpulse<D>(W, u, mu, e);
        const nscd::Vector<D> plastic = nscd::solveLocal<D>(W, u, mu);
        const double scale = u.squaredNorm() / W.diagonal().minCoeff();
        const double lost = -nscd::work<D>(W, u, r), plasticLost = -nscd::work<D>(W, u, plastic);
        // Round-off, which the condition of W magnifies
        EXPECT_GE(lost, (1 - e * e) * plasticLost - 1e-11 * scale);
        EXPECT_GE((W * r + u)[0], -1e-11);
        EXPECT_LE(r.template tail<D - 1>().norm(), mu * r[0] * (1 + 1e-9) + 1e-12);
        if (mu == 0)
        {
            EXPECT_NEAR((W * r + u)[0], -e * u[0], 1e-11);
        }
        least = std::min(least, -(W * r + u)[0] / u[0] / std::max(e, 1e-3));
    }
    EXPECT_LT(least, 0.9);   // some would have gained energy by Newton's rule
}

TYPED_TEST(Impact, BouncesEndWhenAndAsHighAsTheyShould)
{
    constexpr int D = TestFixture::dimension;
    const double e = 0.9, height = 1, dt = 1e-3;
    Scene<D> scene = bouncing<D>(e);
    scene.addFloor();
    scene.add(up<D>(1 + height));
    scene.settings.tolerance = 1e-9;
    auto dynamics = scene.dynamics();
    std::vector<double> tops;
    double last = 0, moved = 0, before = -1;
    for (int i = 0; i < 12000; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
        const double v = dynamics.grains().velocity[0][D - 1];
        if (before > 0 && v <= 0)
        {
            tops.push_back(last - 1);
        }
        before = v;
        last = dynamics.grains().position[0][D - 1];
        moved = std::abs(v) > 1e-6 ? (i + 1) * dt : moved;
    }
    ASSERT_GE(tops.size(), 3);
    for (int k = 1; k <= 3; ++k)
    {
        EXPECT_NEAR(tops[k - 1], height * std::pow(e, 2 * k), 1e-5 * tops[k - 1]) << k;
    }
    EXPECT_NEAR(moved, std::sqrt(2 * height / g) * (1 + e) / (1 - e), 0.01 * moved);
    EXPECT_NEAR(last, 1, 1e-6);
}

TYPED_TEST(Impact, BouncesEndWhateverTheStepThatTheyMeet)
{
    // With the velocity that forces bring by the end of the step one in ten to thirty would bounce for ever
    constexpr int D = TestFixture::dimension;
    Draw draw(5);
    for (const double e : {0.9, 0.95, 0.97})
    {
        Scene<D> scene = bouncing<D>(e);
        scene.addFloor();
        for (int i = 0; i < 100; ++i)
        {
            nscd::Vector<D> x = up<D>(1 + draw.uniform(0.05, 0.5));
            x[0] = 4 * i;
            scene.add(x);
        }
        scene.settings.tolerance = 1e-9;
        auto dynamics = scene.dynamics();
        const double ended = std::sqrt(2 * 0.5 / g) * (1 + e) / (1 - e);
        double fastest = 0;
        for (double t = 0; t < 1.1 * ended; t += 5e-3)
        {
            fastest = fall<D>(dynamics, up<D>(-g), 5e-3).maxVelocity;
        }
        EXPECT_LT(fastest, 1e-6) << "e " << e;
    }
}

TYPED_TEST(Impact, OfABlockThatIsStoppedLeavesNoOverlapBehind)
{
    constexpr int D = TestFixture::dimension;
    const double speed = 12, dt = 0.02;   // a quarter of a radius in a step
    for (const double restitution : {0.5, 0.9, 0.97})
    {
        Scene<D> scene = agitated<D>(D == 2 ? 16 : 8, 0.3, 0.5);
        scene.table.set(0, 0, {0.3, restitution});
        scene.table.set(0, 1, {0.3, restitution});
        scene.settings.tolerance = 1e-3;
        scene.settings.maxSweeps = 30;
        for (nscd::Vector<D>& v : scene.grains.velocity)
        {
            v -= up<D>(speed);
        }
        auto dynamics = scene.dynamics();
        for (int i = 0; i < 100; ++i)
        {
            const auto report = fall<D>(dynamics, up<D>(-g), dt);
            // Where 30 sweeps do not find the solution, they leave 7e-3 at worst
            EXPECT_LE(report.worstOverlap, report.converged ? 1e-3 : 1e-2) << "step " << i << ", e " << restitution;
        }
    }
}

TYPED_TEST(Impact, OfGrainsAtRestIsNone)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene = agitated<D>(D == 2 ? 14 : 5, 0.3, 0.5);   // of 12 x 12 discs one rolls on and on
    const double rolling = D == 2 ? 0 : 0.05;                  // or spheres do
    scene.table.set(0, 0, {0.3, 0.97, rolling});
    scene.table.set(0, 1, {0.3, 0.97, rolling});
    scene.settings.maxSweeps = 500;
    const double dt = 5e-3;
    auto dynamics = scene.dynamics();
    double fastest = 1;
    int steps = 0;
    for (; steps < 10000 && fastest * dt > scene.settings.tolerance; ++steps)
    {
        fastest = fall<D>(dynamics, up<D>(-g), dt).maxVelocity;
    }
    ASSERT_LT(steps, 10000);
    int sweeps = 0;
    std::size_t impacts = 0;
    for (int i = 0; i < 100; ++i)
    {
        const auto report = fall<D>(dynamics, up<D>(-g), dt);
        sweeps = std::max(sweeps, report.sweeps);
        impacts += report.impacts;
    }
    EXPECT_LE(sweeps, 2);   // one that changes nothing, and one for a contact that comes and goes
    EXPECT_EQ(impacts, 0);
}

TYPED_TEST(Impact, OnAWallIsAmongTheContactsAndTheImpulses)
{
    constexpr int D = TestFixture::dimension;
    const double dt = 1e-2, e = 0.8;
    Scene<D> scene = bouncing<D>(e);
    scene.addFloor();
    scene.add(up<D>(1.005), up<D>(-1), 1, 3);
    auto dynamics = scene.dynamics();
    const auto report = fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_EQ(report.impacts, 1);
    EXPECT_NEAR(report.contactWork, -0.5 * 3 * (1 - e * e), 1e-12);
    EXPECT_NEAR(dynamics.contactImpulse()[0][D - 1], 3 * (1 + e), 1e-12);
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1 + e * 0.005, 1e-12);   // half the step down, half up
    const auto contacts = dynamics.contacts();
    ASSERT_EQ(contacts.size(), 1);
    EXPECT_EQ(contacts[0].second, ~0);
    EXPECT_NEAR(contacts[0].force[D - 1], -3 * (1 + e) / dt, 1e-9);
    EXPECT_NEAR(contacts[0].pressing, 3 * (1 + e) / dt, 1e-9);
}

TYPED_TEST(Impact, OnAMovingWallGivesTwiceItsVelocity)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene = bouncing<D>(1);
    scene.addFloor();
    if constexpr (D == 2)
    {
        scene.walls[0].body = 0;
    }
    else
    {
        std::get<nscd::Plane>(scene.walls[0]).body = 0;
    }
    scene.add(up<D>(1.03), up<D>(-1));
    nscd::WallBody<D> wall;
    wall.velocity = up<D>(2);
    nscd::ContactDynamics<D> dynamics(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF, {wall});
    const auto report = fall<D>(dynamics, nscd::Vector<D>::Zero(), 0.02);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 5, 1e-12);
    EXPECT_NEAR(report.contactWork, 0.5 * (25 - 1), 1e-12);
    EXPECT_NEAR(dynamics.grains().position[0][D - 1], 1.03 - 0.01 + 5 * 0.01, 1e-12);   // they meet at 0.01 s
}

TYPED_TEST(Impact, FartherThanTheCandidatesReachIsFollowed)
{
    constexpr int D = TestFixture::dimension;
    // A light grain between a heavy one that comes and nothing near leaves ten times faster than the candidates' skin
    Scene<D> scene = bouncing<D>(1);
    scene.add(inLine<D>(0), inLine<D>(1), 1, 1e6);
    scene.add(inLine<D>(2.01), inLine<D>(-1), 1, 1e-3);
    scene.add(inLine<D>(4.6), inLine<D>(0), 1, 1e-3);
    auto dynamics = scene.dynamics();
    fall<D>(dynamics, nscd::Vector<D>::Zero(), 0.25);
    // It bounces to 3 m/s, meets the third, which takes all, and is overtaken by the first
    EXPECT_NEAR(dynamics.grains().velocity[2][0], 3, 1e-6);
    EXPECT_LE(dynamics.worstOverlap(), 1e-9);
}
