// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Motions with closed-form answers, to the last digits that the scheme allows: block, roller, oblique hits, spin.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace
{

using nscd::Vector;

template <class T>
class Motion : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Motion, Dimensions);

/// A long rod that lies on the floor along x: it slides as a block, without turning.
template <int D>
Scene<D> block(double friction)
{
    Scene<D> scene(friction);
    scene.addFloor();
    scene.grains.clusters.push_back(nscd::makeRod<D>(3, 3));
    scene.add(up<D>(), Vector<D>::Zero(), 3);
    scene.grains.shape[0] = 0;
    return scene;
}

/// A unit grain at the floor, with a velocity along x and the surface speed at its foot against it.
template <int D>
Scene<D> onFloor(double friction, double velocity, double surface = 0)
{
    Scene<D> scene(friction);
    scene.addFloor();
    scene.add(up<D>(), velocity * Vector<D>::UnitX());
    scene.grains.spin[0][D == 2 ? 0 : 1] = D == 2 ? -surface : surface;
    return scene;
}

}  // namespace

TYPED_TEST(Motion, OfABlockOnAnInclineIsThatOfCoulombFriction)
{
    constexpr int D = TestFixture::dimension;
    const double degree = M_PI / 180, dt = 1e-3;
    for (const double angle : {16.6, 16.8, 20.0})   // atan 0.3 is 16.6992 degrees
    {
        auto dynamics = block<D>(0.3).dynamics();
        const int n = 100;
        for (int i = 0; i < n; ++i)
        {
            fall<D>(dynamics, inclined<D>(angle * degree), dt);
        }
        const double a = std::max(0.0, g * (std::sin(angle * degree) - 0.3 * std::cos(angle * degree)));
        EXPECT_EQ(a > 0, angle > 16.6992);
        EXPECT_TRUE(angle < 20 || std::abs(a - 0.589702) < 1e-6);
        // each step ends within tolerance/dt = 1e-10 m/s of the solution
        EXPECT_NEAR(dynamics.grains().velocity[0][0], n * dt * a, n * 1e-10);
        const double t = n * dt;
        EXPECT_NEAR(dynamics.grains().position[0][0], 0.5 * a * t * t + 0.5 * a * t * dt, t * n * 1e-10);
    }
}

TYPED_TEST(Motion, OfASlidingGrainEndsInRollingAtTheSameSpeedForEveryTimeStep)
{
    constexpr int D = TestFixture::dimension;
    constexpr double k = nscd::inertiaFactor<D>;
    const double mu = 0.3;
    const double time = k / (1 + k) / (mu * g);                        // 2/7 or 1/3 over mu g
    const double way = time - 0.5 * mu * g * time * time;              // 12/49 or 5/18 over mu g
    EXPECT_NEAR(way, (D == 3 ? 12.0 / 49 : 5.0 / 18) / (mu * g), 1e-12);
    for (const double dt : {1e-2, 1e-3, 1e-4})
    {
        auto dynamics = onFloor<D>(mu, 1).dynamics();
        double t = 0, rollsFrom = 0, slid = 0;
        while (t < 0.15)
        {
            fall<D>(dynamics, up<D>(-g), dt);
            t += dt;
            const double v = dynamics.grains().velocity[0].x();
            if (rollsFrom == 0 && std::abs(v - rollingVelocity(dynamics.grains(), 0)) < 1e-9)
            {
                rollsFrom = t;
                slid = dynamics.grains().position[0].x() - v * (t - time);
            }
        }
        EXPECT_NEAR(dynamics.grains().velocity[0].x(), 1 / (1 + k), 1e-12);
        EXPECT_NEAR(rollsFrom, time, dt);
        EXPECT_NEAR(slid, way, dt);   // first order, with a speed of 1 m/s
    }
}

TYPED_TEST(Motion, OfASpinningGrainThatIsDroppedIsAThirdOrTwoSeventhsOfItsSurfaceSpeed)
{
    constexpr int D = TestFixture::dimension;
    auto dynamics = onFloor<D>(0.3, 0, 1).dynamics();
    for (int i = 0; i < 20; ++i)
    {
        fall<D>(dynamics, up<D>(-g), 1e-2);
    }
    EXPECT_NEAR(dynamics.grains().velocity[0].x(), D == 2 ? 1.0 / 3 : 2.0 / 7, 1e-12);
}

TYPED_TEST(Motion, AfterAnObliqueHitHasTheTabulatedVelocities)
{
    constexpr int D = TestFixture::dimension;
    struct Row
    {
        double before, after, surface;
    };
    // Sticks up to 3 mu v_n (disc), 3.5 mu v_n (sphere)
    const std::vector<Row> rows = D == 2 ? std::vector<Row>{{0.5, 1.0 / 3, 1.0 / 3}, {2, 1.7, 0.6}}
                                         : std::vector<Row>{{1, 5.0 / 7, 5.0 / 7}, {2, 1.7, 0.75}};
    for (const Row& row : rows)
    {
        Scene<D> scene = onFloor<D>(0.3, row.before);
        scene.grains.velocity[0] -= up<D>();
        auto dynamics = scene.dynamics();
        fall<D>(dynamics, Vector<D>::Zero(), 1e-3);
        EXPECT_NEAR(dynamics.grains().velocity[0][0], row.after, 1e-12);
        EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0, 1e-12);
        EXPECT_NEAR(rollingVelocity(dynamics.grains(), 0), row.surface, 1e-12);
    }
}

TYPED_TEST(Motion, OfAPainleveRodStaysFiniteAndDoesNotEnterTheFloor)
{
    constexpr int D = TestFixture::dimension;
    // A slender rod slides at an angle with the friction that presses its foot to the floor: above
    // mu = (tan + 4 cot)/3 it must jam
    for (const double mu : {0.5, 1.5, 5.0, 50.0})
    {
        for (const double angle : {0.6, std::atan(2.0), 1.3})
        {
            Scene<D> scene(mu);
            scene.addFloor();
            scene.grains.clusters.push_back(nscd::makeRod<D>(20, 20));
            const double foot = 0.05 + 0.95 * std::sin(angle);   // members of radius 1/20
            scene.add(up<D>(foot), -Vector<D>::UnitX(), 1);
            scene.grains.shape[0] = 0;
            scene.settings.maxSweeps = 2000;
            if constexpr (D == 2)
            {
                scene.grains.orientation[0] = nscd::Orientation<2>(angle);
            }
            else
            {
                scene.grains.orientation[0] = Eigen::AngleAxisd(-angle, Vector<3>::UnitY());
            }
            auto dynamics = scene.dynamics();
            double energy = 0.5 + g * foot;
            for (int i = 0; i < 300; ++i)
            {
                fall<D>(dynamics, up<D>(-g), 1e-3);
                const auto& v = dynamics.grains().velocity[0];
                ASSERT_TRUE(v.allFinite() && dynamics.grains().spin[0].allFinite());
                for (const auto& contact : dynamics.contacts())
                {
                    ASSERT_TRUE(contact.force.allFinite());
                    ASSERT_GE(-contact.force[D - 1], 0);   // on the wall: downwards
                }
                // Turning by spin dt moves points by (spin dt)^2/2 of their arm off their tangent
                ASSERT_LT(dynamics.worstOverlap(), 1e-4) << "mu " << mu << ", angle " << angle << ", step " << i;
            }
            EXPECT_LT(0.5 * dynamics.grains().velocity[0].squaredNorm(), energy);
        }
    }
}
