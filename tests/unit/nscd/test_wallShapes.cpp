// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls of segments: joints, corners, ends, both sides.

#include "Scene.hpp"

#include <gtest/gtest.h>

using nscd::Vector;

namespace wallShapes
{

constexpr double dt = 1e-2;

/// Velocity and height after sliding 3 m over a floor cut into pieces at the given places.
std::pair<Vector<2>, double> slide(const std::vector<double>& joints, double friction)
{
    Scene<2> scene(friction);
    for (std::size_t j = 0; j + 1 < joints.size(); ++j)
    {
        scene.walls.push_back({{joints[j], 0}, {joints[j + 1], 0}, 1});
    }
    scene.add({-1.5, 1}, {1, 0});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 300; ++i)
    {
        const nscd::StepReport report = fall<2>(dynamics, up<2>(-g), dt);
        EXPECT_EQ(report.active, 1u);
    }
    return {dynamics.grains().velocity[0], dynamics.grains().position[0].y()};
}

TEST(Joint, OfCollinearSegmentsIsNotFelt)
{
    for (const double friction : {0.0, 0.3})
    {
        const auto whole = slide({-10, 10}, friction);
        const auto pieces = slide({-10, -1, -0.75, 0, 0.3, 0.31, 1, 10}, friction);
        EXPECT_LE((pieces.first - whole.first).norm(), 1e-12);
        EXPECT_NEAR(pieces.second, 1, 1e-12);
    }
}

TEST(Joint, RightBelowTheGrainIsOneContact)
{
    Scene<2> scene;
    scene.walls = {{{-5, 0}, {0, 0}, 1}, {{0, 0}, {5, 0}, 1}};
    scene.add({0, 1});
    auto dynamics = scene.dynamics();
    EXPECT_EQ(fall<2>(dynamics, up<2>(-g), dt).contacts, 1u);
    EXPECT_NEAR(dynamics.contactImpulse()[0].y(), g * dt, 1e-12);
}

TEST(ConcaveCorner, HoldsAGrainOnBothSides)
{
    Scene<2> scene;
    scene.walls = {{{0, 0}, {10, 0}, 1}, {{0, 10}, {0, 0}, 1}};
    scene.add({1, 1});
    auto dynamics = scene.dynamics();
    const Vector<2> gravity(-3, -4);
    EXPECT_EQ(fall<2>(dynamics, gravity, dt).active, 2u);
    EXPECT_LE(dynamics.grains().velocity[0].norm(), 1e-12);
    EXPECT_LE((dynamics.contactImpulse()[0] + dt * gravity).norm(), 1e-12);
}

TEST(ConcaveCorner, OfAnObtuseAngleStopsAFastGrainInTime)
{
    Scene<2> scene;
    scene.walls = {{{-10, 0}, {0, 0}, 1}, {{0, 0}, {10, 10}, 1}};
    scene.add({-1.39, 1}, {1 / dt, 0});   // one radius per step; touches the slope 0.98 away
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, Vector<2>::Zero(), dt);
    EXPECT_LE(dynamics.worstOverlap(), 1e-10);
}

TEST(Ridge, DoesNotCarryAGrainThatOnlyTheFloorBehindItIsLevelWith)
{
    // The ridge and the step are smaller than the grain; continued, the floor behind would hold it 0.1 too high
    Scene<2> scene;
    scene.walls = {{{-4, 0}, {0, 0}, 1},
                   {{0, 0}, {0.1, 0.2}, 1},
                   {{0.1, 0.2}, {0.3, 0.1}, 1},
                   {{0.3, 0.1}, {4, 0.1}, 1}};
    scene.add({-1.2, 1.3}, {0, -1});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 50; ++i)
    {
        fall<2>(dynamics, up<2>(-g), dt);
    }
    EXPECT_NEAR(dynamics.grains().position[0].y(), 1, 1e-10);
    EXPECT_EQ(dynamics.grains().position[0].x(), -1.2);
}

TEST(ConvexCorner, TurnsAGrainAroundItWithoutOverlap)
{
    Scene<2> scene;
    scene.walls = {{{-10, 0}, {0, 0}, 1}, {{0, 0}, {0, -10}, 1}};
    scene.add({0, 1}, {0.1, 0});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 200; ++i)
    {
        EXPECT_LE(fall<2>(dynamics, up<2>(-g), 1e-3).contacts, 1u);
        EXPECT_LE(dynamics.worstOverlap(), 1e-12);
    }
    EXPECT_GT(dynamics.grains().position[0].x(), 0);
}

TEST(Segment, WorksFromBothSides)
{
    Scene<2> scene;
    scene.walls = {{{-10, 0}, {10, 0}, 1}};
    scene.add({-2, 1.5});
    scene.add({2, -1.5});
    scene.grains.velocity = {{0, -1}, {0, 1}};
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 100; ++i)
    {
        fall<2>(dynamics, Vector<2>::Zero(), dt);
    }
    EXPECT_NEAR(dynamics.grains().position[0].y(), 1, 1e-10);
    EXPECT_NEAR(dynamics.grains().position[1].y(), -1, 1e-10);
}

TEST(Segment, StopsAGrainAtItsFreeEnd)
{
    Scene<2> scene;
    scene.walls = {{{0, 0}, {0, -5}, 1}};
    scene.add({0, 1.3}, {0, -1});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 100; ++i)
    {
        fall<2>(dynamics, Vector<2>::Zero(), dt);
    }
    EXPECT_NEAR(dynamics.grains().position[0].y(), 1, 1e-10);
}

TEST(Segment, PushesACentreThatLiesOnItToOneSide)
{
    Scene<2> scene;
    scene.walls = {{{-5, 0}, {5, 0}, 1}};
    scene.add({0, 0});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 20; ++i)
    {
        fall<2>(dynamics, Vector<2>::Zero(), dt);
    }
    EXPECT_NEAR(std::abs(dynamics.grains().position[0].y()), 1, 1e-10);
}

TEST(Segment, IsNotCrossedByAGrainThatFallsFast)
{
    Scene<2> scene;
    scene.addFloor();
    scene.add({0, 2}, {3, -40});
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, up<2>(-g), 1);
    EXPECT_NEAR(dynamics.grains().position[0].y(), 1, 1e-9);
}

TEST(Plane, OfAnyDirectionCarriesAGrain)
{
    Scene<3> scene;
    const Vector<3> normal = Vector<3>(1, 2, 3).normalized();
    scene.walls.push_back(nscd::Plane{{1, 1, 1}, normal, 1});
    scene.add(Vector<3>(1, 1, 1) + 1.2 * normal, -normal);
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 50; ++i)
    {
        fall<3>(dynamics, -g * normal, dt);
    }
    EXPECT_LE((dynamics.grains().position[0] - Vector<3>(1, 1, 1) - normal).norm(), 1e-10);
}

}  // namespace wallShapes
