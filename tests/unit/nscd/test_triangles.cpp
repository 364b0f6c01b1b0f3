// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Geometry of walls of triangles: which triangle of a surface speaks for it, and where.

#include "Surfaces.hpp"

#include "nscd/walls/WallContact.hpp"

#include <gtest/gtest.h>

namespace
{

constexpr double radius = 0.5;

/// Contacts of a sphere with all triangles of a surface.
std::vector<nscd::Approach<3>> contacts(const nscd::WallContact<3>& walls, std::size_t number, const Point& x)
{
    std::vector<nscd::Approach<3>> found;
    for (std::size_t w = 0; w < number; ++w)
    {
        if (const auto approach = walls.approach(static_cast<int>(w), x, radius))
        {
            found.push_back(*approach);
        }
    }
    return found;
}

Point randomPoint(nscd::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

}  // namespace

TEST(Triangle, IsAsFarAwayAsASearchFinds)
{
    nscd::Random random(1);
    for (int i = 0; i < 100; ++i)
    {
        const nscd::Triangle triangle{randomPoint(random, 1), randomPoint(random, 1), randomPoint(random, 1)};
        const nscd::WallContact<3> walls({triangle});
        const Point x = randomPoint(random, 2);
        EXPECT_NEAR(walls.distance(0, x), searchedDistance(triangle, x), 1e-12);
        const auto approach = walls.approach(0, x, radius);
        ASSERT_TRUE(approach);
        EXPECT_NEAR(approach->gap, walls.distance(0, x) - radius, 1e-14);
        EXPECT_NEAR(approach->normal.norm(), 1, 1e-14);
        const Point nearest = x + (approach->gap + radius) * approach->normal;
        EXPECT_LE(walls.distance(0, nearest), 1e-12);   // the normal points at the nearest point
    }
}

TEST(Triangle, IsNotMetBeyondItsReach)
{
    // Two that lean against each other, a hollow on one side and a ridge on the other, and a half space
    nscd::Random random(3);
    for (int i = 0; i < 2000; ++i)
    {
        const Point a = randomPoint(random, 1), b = randomPoint(random, 1);
        const nscd::WallContact<3> walls({nscd::Triangle{a, b, randomPoint(random, 1)},
                                          nscd::Triangle{b, a, randomPoint(random, 1)},
                                          nscd::Plane{a, randomPoint(random, 1).normalized()}});
        const Point x = randomPoint(random, 2);
        const double margin = random.uniform(0, 1);
        for (int w = 0; w < 3; ++w)
        {
            const auto approach = walls.approach(w, x, radius);
            EXPECT_TRUE(!walls.isBeyond(w, x, radius + margin) || !approach || approach->gap > margin);
        }
    }
}

TEST(Triangle, PushesACentreThatLiesOnItToTheSideOfItsNormal)
{
    const nscd::WallContact<3> walls({nscd::Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    for (const Point& x : {Point(0.2, 0.3, 0), Point(0.5, 0, 0), Point(0.5, 0.5, 0), Point(0, 0, 0), Point(1, 0, 0)})
    {
        const auto approach = walls.approach(0, x, radius);
        ASSERT_TRUE(approach);
        EXPECT_EQ(approach->gap, -radius);
        EXPECT_EQ(approach->normal, Point(0, 0, -1));
    }
}

TEST(Triangle, IsMetFromBothSides)
{
    const nscd::WallContact<3> walls({nscd::Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    for (const double side : {1.0, -1.0})
    {
        const auto approach = walls.approach(0, {0.2, 0.3, 0.7 * side}, radius);
        ASSERT_TRUE(approach);
        EXPECT_NEAR(approach->gap, 0.2, 1e-15);
        EXPECT_EQ(approach->normal, Point(0, 0, -side));
    }
}

TEST(Surface, IsMetAtItsNearestPointByOneTriangleOnly)
{
    const Surface surface = bumpySurface(2, 2);
    const nscd::WallContact<3> walls(surface);
    nscd::Random random(2);
    for (int i = 0; i < 500; ++i)
    {
        const Point x = randomPoint(random, 2.5);
        double nearest = 1e300;
        for (std::size_t w = 0; w < surface.size(); ++w)
        {
            nearest = std::min(nearest, walls.distance(static_cast<int>(w), x));
        }
        const auto found = contacts(walls, surface.size(), x);
        int atNearest = 0;
        for (const auto& contact : found)
        {
            EXPECT_GE(contact.gap, nearest - radius - 1e-13);
            atNearest += contact.gap < nearest - radius + 1e-13;
        }
        EXPECT_EQ(atNearest, 1);
    }
}

TEST(Surface, IsMetAtMinimaOfTheDistanceOrContinuedInAHollow)
{
    const Surface surface = bumpySurface(2, 2);
    const nscd::WallContact<3> walls(surface);
    const auto distance = [&](const Point& p)
    {
        double nearest = 1e300;
        for (std::size_t w = 0; w < surface.size(); ++w)
        {
            nearest = std::min(nearest, walls.distance(static_cast<int>(w), p));
        }
        return nearest;
    };
    nscd::Random random(3);
    int minima = 0;
    int continued = 0;
    for (int i = 0; i < 200; ++i)
    {
        const Point x = randomPoint(random, 2.5);
        for (const auto& contact : contacts(walls, surface.size(), x))
        {
            const Point foot = x + (contact.gap + radius) * contact.normal;
            if (distance(foot) < 1e-12)
            {
                ++minima;
                // No point of the surface near the foot is nearer to x: a small ball around a point just before
                // the foot does not meet the surface
                const double h = 1e-8;   // no foot is so near to the edge of a hollow
                EXPECT_NEAR(distance(foot - h * contact.normal), h, 1e-3 * h);
            }
            else
            {
                ++continued;
                EXPECT_GT(contact.gap, 0);
            }
        }
    }
    EXPECT_GT(minima, 500);
    EXPECT_GT(continued, 20);
}

TEST(Floor, IsOneContactAlsoAboveItsEdgesAndCorners)
{
    Surface surface;
    addParallelogram(surface, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 4);
    const nscd::WallContact<3> walls(surface);
    for (const Point& x : {Point(0, 0, 0.4), Point(0.5, 0, 0.4), Point(0.5, 0.5, 0.4), Point(0.3, 0.6, 0.4),
                           Point(1, 1, 0.4), Point(0.1, 0.1, 0.4), Point(0.1, 0.9, -0.4)})
    {
        const auto found = contacts(walls, surface.size(), x);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0].gap, -0.1, 1e-15);
        EXPECT_NEAR(found[0].normal.z(), x.z() > 0 ? -1 : 1, 1e-15);
    }
}

TEST(Floor, OfStripsThatAreCutDifferentlyIsOneContact)
{
    Surface surface;
    addParallelogram(surface, {-2, -2, 0}, {2, 0, 0}, {0, 4, 0}, 3);
    addParallelogram(surface, {0, -2, 0}, {2, 0, 0}, {0, 4, 0}, 5);
    addParallelogram(surface, {-2, 2, 0}, {4, 0, 0}, {0, 1, 0}, 1);
    const nscd::WallContact<3> walls(surface);
    nscd::Random random(4);
    for (int i = 0; i < 2000; ++i)
    {
        const double nearJoint = i % 2 ? 1e-3 : 1.0;
        const Point x(nearJoint * random.uniform(-1, 1), random.uniform(-1.5, 2.9), 0.4);
        const auto found = contacts(walls, surface.size(), x);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0].gap, -0.1, 1e-15);
    }
}

TEST(Corners, ThatDifferByRoundOffAreOne)
{
    nscd::Random random(5);
    Surface surface;
    addParallelogram(surface, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 4);
    for (auto& wall : surface)
    {
        auto& triangle = std::get<nscd::Triangle>(wall);
        for (Point* corner : {&triangle.a, &triangle.b, &triangle.c})
        {
            *corner += randomPoint(random, 1e-10);
        }
    }
    const nscd::WallContact<3> walls(surface);
    for (int i = 0; i < 500; ++i)
    {
        const Point x(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), 0.4);
        const auto found = contacts(walls, surface.size(), x);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found[0].gap, -0.1, 1e-9);
    }
}

TEST(ConcaveJoint, ContinuesBothFaces)
{
    // A floor for x < 0 and a slope of 45 degrees for x > 0, each of pieces that do not end at the same places
    Surface surface;
    addParallelogram(surface, {-4, -4, 0}, {4, 0, 0}, {0, 8, 0}, 4);
    addParallelogram(surface, {0, -4, 0}, {4, 0, 4}, {0, 8, 0}, 3);
    const nscd::WallContact<3> walls(surface);
    nscd::Random random(6);
    for (int i = 0; i < 500; ++i)
    {
        const double y = i < 20 ? -4 + 0.4 * i : random.uniform(-3, 3);
        const Point x(random.uniform(-1.5, -0.6), y, 0.55);   // its foot on the slope's plane is below the floor
        const auto found = contacts(walls, surface.size(), x);
        ASSERT_EQ(found.size(), 2u);
        double sum = 0;
        for (const auto& contact : found)
        {
            const bool floor = contact.normal.z() < -0.99;
            const double expected = floor ? 0.05 : (x.z() - x.x()) / std::sqrt(2.0) - radius;
            EXPECT_NEAR(contact.gap, expected, 1e-14);
            sum += contact.normal.z();
        }
        EXPECT_NEAR(sum, -1 - std::sqrt(0.5), 1e-14);
    }
}

TEST(Ridge, HidesTheFaceBehindIt)
{
    // Two floors and a ridge between them that is smaller than the grain; the floor behind is higher
    const double profile[][2] = {{-4, 0}, {0, 0}, {0.1, 0.2}, {0.3, 0.1}, {4, 0.1}};
    Surface surface;
    for (int i = 0; i < 4; ++i)
    {
        const auto& [x, z] = profile[i];
        const auto& [nextX, nextZ] = profile[i + 1];
        addParallelogram(surface, {x, -4, z}, {nextX - x, 0, nextZ - z}, {0, 8, 0}, 1, i);
    }
    const nscd::WallContact<3> walls(surface);
    const auto found = contacts(walls, surface.size(), {-0.6, 0.3, 0.5});
    ASSERT_EQ(found.size(), 2u);   // the floor and the ridge's flank, which it would meet next
    for (const auto& contact : found)
    {
        EXPECT_GE(contact.gap, 0);
    }
}

TEST(Surfaces, OfDifferentBodiesAreNotJoined)
{
    // Two halves of a floor: seen from above one half, the other's edge is a contact of its own
    Surface surface;
    addTriangle(surface, {-4, -4, 0}, {0, -4, 0}, {0, 4, 0});
    surface.push_back(nscd::Triangle{{0, -4, 0}, {4, 4, 0}, {0, 4, 0}, 1, 0});
    const nscd::WallContact<3> walls(surface);
    const auto found = contacts(walls, surface.size(), {-0.3, 0, 0.4});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].gap, -0.1, 1e-15);
    EXPECT_NEAR(found[1].gap, 0, 1e-15);   // 3-4-5
}
