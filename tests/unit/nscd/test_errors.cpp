// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is refused, and in which words.

#include "Messages.hpp"
#include "Scene.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace errors
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusal(const std::function<void(Scene<2>&)>& spoil)
{
    Scene<2> scene = agitated<2>(2, 0.3);
    spoil(scene);
    return messageOf<std::invalid_argument>([&] { scene.dynamics(); });
}

TEST(Grains, WithListsOfDifferentLengthsAreRefused)
{
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.id.pop_back(); }), "grains: 4 positions but 3 entries of id");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.velocity.pop_back(); }),
              "grains: 4 positions but 3 entries of velocity");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.spin.pop_back(); }), "grains: 4 positions but 3 entries of spin");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.radius.pop_back(); }), "grains: 4 positions but 3 entries of radius");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.mass.pop_back(); }), "grains: 4 positions but 3 entries of mass");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.material.pop_back(); }),
              "grains: 4 positions but 3 entries of material");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.temperature.pop_back(); }),
              "grains: 4 positions but 3 entries of temperature");
}

TEST(Grains, WithSenselessValuesAreRefusedByName)
{
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.position[1].x() = notANumber; }), "grain 101: position is not finite");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.velocity[1].y() = infinity; }), "grain 101: velocity is not finite");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.spin[1][0] = notANumber; }), "grain 101: spin is not finite");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.temperature[1] = notANumber; }),
              "grain 101: temperature is not finite");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.radius[3] = 0; }), "grain 103: radius 0 m is not positive");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.radius[3] = notANumber; }), "grain 103: radius is not finite");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.mass[0] = -2; }), "grain 100: mass -2 kg is not positive");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.material[2] = 2; }),
              "grain 102: material 2 is not one of the 2 of the contact table");
}

TEST(Walls, WithSenselessValuesAreRefusedByNumber)
{
    EXPECT_EQ(refusal([](Scene<2>& s) { s.walls[2].b = s.walls[2].a = {1, 2}; }),
              "wall 2: its two end points coincide at (1, 2)");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.walls[2].b.x() = notANumber; }), "wall 2: an end point is not finite");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.walls[0].material = -1; }),
              "wall 0: material -1 is not one of the 2 of the contact table");

    Scene<3> scene = agitated<3>(2, 0);
    auto& plane = std::get<nscd::Plane>(scene.walls[1]);
    plane.normal *= 2;
    EXPECT_EQ(messageOf<std::invalid_argument>([&] { scene.dynamics(); }),
              "wall 1: its normal has length 2 instead of 1");
    plane.normal[0] = notANumber;
    EXPECT_EQ(messageOf<std::invalid_argument>([&] { scene.dynamics(); }), "wall 1: point or normal is not finite");
}

TEST(Friction, OutsideItsRangeIsRefused)
{
    EXPECT_EQ(refusal([](Scene<2>& s) { s.table.set(0, 1, {-0.1}); }),
              "contact table: friction -0.1 of materials 0 and 1 is not a number >= 0");
}

TEST(ContactLaw, OutsideItsRangeIsRefused)
{
    const auto refused = [](double nscd::ContactParameters::*parameter, double value)
    {
        return refusal(
            [&](Scene<2>& s)
            {
                nscd::ContactParameters law;
                law.*parameter = value;
                s.table.set(1, 1, law);
            });
    };
    const std::string of = " of materials 1 and 1 is not a number ";
    using P = nscd::ContactParameters;
    EXPECT_EQ(refused(&P::restitution, 1.1), "contact table: restitution 1.1" + of + "between 0 and 1");
    EXPECT_EQ(refused(&P::restitution, notANumber), "contact table: restitution nan" + of + "between 0 and 1");
    EXPECT_EQ(refused(&P::rolling, -1), "contact table: rolling -1" + of + ">= 0");
    EXPECT_EQ(refused(&P::cohesion, -2), "contact table: cohesion -2" + of + ">= 0");
    EXPECT_EQ(refused(&P::tension, infinity), "contact table: tension inf" + of + ">= 0");
    EXPECT_EQ(refused(&P::cohesionDelay, -3), "contact table: cohesionDelay -3" + of + ">= 0");
}

TEST(Clusters, ThatDoNotExistOrMakeNoSenseAreRefused)
{
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.shape[1] = 0; }),
              "grain 101: shape 0 is neither -1 nor one of the 0 clusters");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.shape[0] = -2; }),
              "grain 100: shape -2 is neither -1 nor one of the 0 clusters");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.clusters.emplace_back(); }),
              "cluster 0: needs members with finite centres and positive radii, and positive moments");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.grains.orientation[1].angle() = notANumber; }),
              "grain 101: orientation is not finite");
}

TEST(Settings, WithoutSenseAreRefused)
{
    EXPECT_EQ(refusal([](Scene<2>& s) { s.settings.tolerance = 0; }), "settings: tolerance 0 m is not positive");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.settings.maxSweeps = 0; }), "settings: maxSweeps 0 is less than 1");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.settings.maxDisplacement = -1; }),
              "settings: maxDisplacement -1 is not positive");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.settings.blocks = 6; }),
              "settings: blocks 6 is not a power of two between 1 and 4096");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.settings.period[1] = -1; }), "settings: period -1 m is not a number >= 0");
    EXPECT_EQ(refusal([](Scene<2>& s) { s.settings.period[0] = notANumber; }),
              "settings: period nan m is not a number >= 0");
    EXPECT_EQ(refusal(
                  [](Scene<2>& s)
                  {
                      s.grains.radius[0] = 1;
                      s.settings.period[0] = 3.9;
                  }),
              "settings: period 3.9 m is less than four of the largest radii, 1 m: a grain could touch another one "
              "twice");
    const auto farSteps = [](double period)
    {
        return [period](Scene<2>& s)
        {
            s.grains.radius.assign(s.grains.size(), 1);
            s.settings.maxDisplacement = 0.75;
            s.settings.period[0] = period;
        };
    };
    EXPECT_EQ(refusal(farSteps(9.9)),
              "settings: maxDisplacement 0.75 in a period of 9.9 m: a grain could pass another one's next image "
              "unseen; at most 0.5, or a period of 10 m");
    EXPECT_EQ(refusal(farSteps(10)), "nothing was thrown");
}

TEST(Step, WithWrongListsOrTimeStepIsRefused)
{
    auto dynamics = agitated<2>(2, 0).dynamics();
    const nscd::Vectors<2> force(4, {0, 0});
    const nscd::Spins<2> torque(4, nscd::Spin<2>::Zero());
    EXPECT_EQ(messageOf<std::invalid_argument>([&] { dynamics.step({}, torque, 1); }),
              "4 grains but 0 forces and 4 torques");
    EXPECT_EQ(messageOf<std::invalid_argument>([&] { dynamics.step(force, torque, 0); }),
              "time step 0.000000 s is not positive");
    EXPECT_EQ(messageOf<std::invalid_argument>([&] { dynamics.step(force, torque, notANumber); }),
              "time step nan s is not positive");
}

TEST(Step, WithValuesThatAreNotFiniteNamesTheGrain)
{
    auto dynamics = agitated<2>(2, 0).dynamics();
    nscd::Vectors<2> force(4, {0, 0});
    nscd::Spins<2> torque(4, nscd::Spin<2>::Zero());
    torque[3][0] = notANumber;
    EXPECT_EQ(messageOf<std::runtime_error>([&] { dynamics.step(force, torque, 1); }),
              "grain 103: torque is not finite");
    force[1].x() = infinity;
    EXPECT_EQ(messageOf<std::runtime_error>([&] { dynamics.step(force, torque, 1); }),
              "grain 101: force is not finite");
}

TEST(Step, TooFarForSubStepsIsRefused)
{
    auto dynamics = agitated<2>(2, 0).dynamics();
    const nscd::Vectors<2> force(4, {1e20, 0});
    EXPECT_NE(messageOf<std::runtime_error>([&] { dynamics.step(force, nscd::Spins<2>(4, nscd::Spin<2>::Zero()), 1); })
                  .find("too far for sub-steps"),
              std::string::npos);
}

}  // namespace errors
