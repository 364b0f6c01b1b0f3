// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls that move with bodies: where they are.

#include "Surfaces.hpp"

#include "nscd/walls/WallContact.hpp"

#include <gtest/gtest.h>

namespace wallMotion
{

constexpr double radius = 0.4;

nscd::WallBody<3> bodyAt(const Point& position, double angle = 0, const Point& axis = Point::UnitZ())
{
    nscd::WallBody<3> body;
    body.position = position;
    body.orientation = Eigen::AngleAxisd(angle, axis.normalized());
    return body;
}

nscd::WallBody<2> discAt(const nscd::Vector<2>& position, double angle = 0)
{
    nscd::WallBody<2> body;
    body.position = position;
    body.orientation = nscd::Orientation<2>(angle);
    return body;
}

/// A box on body 0, a floor that stays.
Surface boxAndFloor()
{
    Surface surface = boxSurface({1, 1.2, 1.4}, 3);
    for (auto& wall : surface)
    {
        std::get<nscd::Triangle>(wall).body = 0;
    }
    addParallelogram(surface, {-3, -3, -1}, {6, 0, 0}, {0, 6, 0}, 3);
    return surface;
}

TEST(MovedWalls, MeetAGrainThatMovesAlongAsBefore)
{
    const Surface surface = boxAndFloor();
    const std::vector<nscd::WallBody<3>> initial{bodyAt({0.3, 0.2, 0.1})};
    const std::vector<nscd::WallBody<3>> now{bodyAt({1, -2, 3}, 2.1, {1, 2, 3})};
    const Eigen::Matrix3d turn = now[0].orientation.toRotationMatrix();
    const nscd::WallContact<3> still(surface);
    nscd::WallContact<3> moved(surface);
    moved.place(initial, now);
    nscd::Random random(1);
    for (int i = 0; i < 100; ++i)
    {
        const Point x(random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.7), random.uniform(-0.5, 1.9));
        const Point y = now[0].position + turn * (x - initial[0].position);
        for (int w = 0; w < static_cast<int>(surface.size()); ++w)
        {
            const bool fixed = nscd::bodyOf(surface[w]) < 0;
            const auto before = still.approach(w, x, radius);
            const auto after = moved.approach(w, fixed ? x : y, radius);
            ASSERT_EQ(before.has_value(), after.has_value());
            if (before)
            {
                EXPECT_NEAR(after->gap, before->gap, 1e-14);
                EXPECT_LE((after->normal - (fixed ? before->normal : Point(turn * before->normal))).norm(), 1e-14);
            }
        }
    }
}

TEST(MovedWalls, AreFoundWhereTheyAre)
{
    const Surface surface = boxAndFloor();
    const std::vector<nscd::WallBody<3>> initial{bodyAt({0, 0, 0})};
    nscd::WallContact<3> walls(surface);
    nscd::Random random(2);
    for (int i = 0; i < 50; ++i)
    {
        const Point position(random.uniform(-2, 2), random.uniform(-2, 2), 0);
        walls.place(initial, {bodyAt(position, random.uniform(0, 6), {1, 0, 1})});
        const Point x(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-1, 2));
        std::vector<int> found;
        walls.forNear(x, 0.5, [&](int wall) { found.push_back(wall); });
        std::sort(found.begin(), found.end());
        std::vector<int> expected;
        for (int w = 0; w < static_cast<int>(surface.size()); ++w)
        {
            if (walls.distance(w, x) < 0.5)
            {
                expected.push_back(w);
            }
        }
        EXPECT_EQ(found, expected);
    }
}

TEST(MovedWalls, ThatHaveComeBackAreTheSameToTheLastBit)
{
    const Surface surface = boxAndFloor();
    const std::vector<nscd::WallBody<3>> initial{bodyAt({0.3, 0.2, 0.1})};
    const nscd::WallContact<3> still(surface);
    nscd::WallContact<3> moved(surface);
    moved.place(initial, {bodyAt({1, 1, 1}, 0.3)});
    moved.place(initial, initial);
    for (int w = 0; w < static_cast<int>(surface.size()); ++w)
    {
        EXPECT_EQ(moved.distance(w, {0.1, 0.7, 2}), still.distance(w, {0.1, 0.7, 2}));
    }
}

TEST(MovedWalls, In2DTurnAboutTheirBody)
{
    const nscd::Walls<2> walls{{{0, 0}, {1, 0}, 0, 0}, {{0, 5}, {1, 5}}};
    nscd::WallContact<2> contact(walls);
    contact.place({discAt({0, 0})}, {discAt({2, 0}, M_PI / 2)});   // from (2, 0) to (2, 1)
    const auto approach = contact.approach(0, {3, 0.5}, radius);
    ASSERT_TRUE(approach);
    EXPECT_NEAR(approach->gap, 1 - radius, 1e-15);
    EXPECT_NEAR(approach->normal.x(), -1, 1e-15);
    EXPECT_NEAR(contact.distance(1, {0.5, 4}), 1, 1e-15);
}

TEST(MovedPlane, GoesWithItsBody)
{
    nscd::WallContact<3> walls({nscd::Plane{{0, 0, 0}, {0, 0, 1}, 0, 0}, nscd::Plane{{0, 0, 0}, {0, 0, 1}}});
    walls.place({bodyAt({1, 1, 1})}, {bodyAt({4, 5, 3})});
    EXPECT_NEAR(walls.approach(0, {0, 0, 3}, radius)->gap, 1 - radius, 1e-15);
    EXPECT_NEAR(walls.approach(1, {0, 0, 3}, radius)->gap, 3 - radius, 1e-15);
}

TEST(MovedPlane, DoesNotTurn)
{
    nscd::WallContact<3> walls({nscd::Plane{{0, 0, 0}, {0, 0, 1}, 0, 0}});
    try
    {
        walls.place({bodyAt({0, 0, 0})}, {bodyAt({0, 0, 0}, 0.1)});
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_STREQ(error.what(), "wall 0: a plane cannot turn with its body 0; make it of triangles");
    }
}

}  // namespace wallMotion
