// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Impacts in a fluid: the Stokes number that the law of restitution sees, and what becomes of its answer.

#include "Messages.hpp"
#include "Scene.hpp"

#include <gtest/gtest.h>

namespace lubrication
{

constexpr double dt = 1e-3;

template <class T>
class Lubrication : public testing::Test
{
public:
    static constexpr int dimension = T::value;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Lubrication, Dimensions);

/// Keeps what it is asked for.
struct Law
{
    double answer;
    std::vector<double> restitution, stokes;

    nscd::WetRestitution asked()
    {
        return [this](double e, double st)
        {
            restitution.push_back(e);
            stokes.push_back(st);
            return answer;
        };
    }
};

TYPED_TEST(Lubrication, LawIsAskedForTheStokesNumberOfAGrainAtAWall)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0, 0.9);
    scene.addFloor();
    scene.add(up<D>(2.001), up<D>(-3), 2, 5);
    auto dynamics = scene.dynamics();
    Law law{0.4, {}, {}};
    dynamics.setLubrication(law.asked(), {0.07});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    ASSERT_FALSE(law.stokes.empty());
    EXPECT_EQ(law.restitution[0], 0.9);
    EXPECT_NEAR(law.stokes[0], 5 * 3 / (6 * M_PI * 0.07 * 4), 1e-12);
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0.4 * 3, 1e-12);
}

TYPED_TEST(Lubrication, TwoGrainsHaveTheirReducedMassAndRadius)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0, 0.9);
    scene.add(nscd::Vector<D>::Zero(), nscd::Vector<D>::UnitX(), 1, 2);
    scene.add(4.0005 * nscd::Vector<D>::UnitX(), -nscd::Vector<D>::UnitX(), 3, 5);
    auto dynamics = scene.dynamics();
    Law law{0, {}, {}};
    dynamics.setHeaviness({1.5, 1.2});
    dynamics.setLubrication(law.asked(), {0.02, 0.04});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    ASSERT_FALSE(law.stokes.empty());
    const double radius = 0.75;
    EXPECT_NEAR(law.stokes[0], 2 / (6 * M_PI * radius * radius * (0.02 / 3 + 0.04 / 6)), 1e-12);
    const auto& velocity = dynamics.grains().velocity;
    EXPECT_NEAR((velocity[0] - velocity[1]).norm(), 0, 1e-12);
}

TYPED_TEST(Lubrication, EndsWithTheListOfGrains)
{
    constexpr int D = TestFixture::dimension;
    Scene<D> scene(0, 0.9);
    scene.addFloor();
    scene.add(up<D>(1.0005), up<D>(-1));
    scene.add(10 * nscd::Vector<D>::UnitX() + up<D>(2));
    auto dynamics = scene.dynamics();
    Law law{0, {}, {}};
    dynamics.setLubrication(law.asked(), {1, 1});
    dynamics.remove({false, true});
    fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
    EXPECT_TRUE(law.stokes.empty());
    EXPECT_NEAR(dynamics.grains().velocity[0][D - 1], 0.9, 1e-12);
    EXPECT_EQ(invalid([&] { dynamics.setLubrication(law.asked(), {1, 1}); }), "1 grains but 2 viscosities");
}

}  // namespace lubrication
