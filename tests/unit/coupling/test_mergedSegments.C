/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "wallPieces.H"

#include <random>

using namespace Foam;

namespace
{

typedef nscd::Vector<2> Point;

// A box of width 3 and height 1 in n pieces a side
nscd::Walls<2> box(const int n)
{
    const std::vector<Point> corners{{0, 0}, {3, 0}, {3, 1}, {0, 1}};
    nscd::Walls<2> walls;
    for (std::size_t side = 0; side < 4; ++side)
    {
        const Point a = corners[side], b = corners[(side + 1) % 4];
        const auto at = [&](const int i) { return Point(a + (b - a)*i/n); };
        for (int i = 0; i < n; ++i)
        {
            walls.push_back({at(i), at(i + 1), 0});
        }
    }
    return walls;
}

bool same(const nscd::Walls<2>& one, const nscd::Walls<2>& other)
{
    const auto equal = [](const nscd::Segment& s, const nscd::Segment& t)
    {
        return s.a == t.a && s.b == t.b && s.material == t.material;
    };
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), equal);
}

}


TEST(MergedSegments, MakeFourWallsOfABox)
{
    const nscd::Walls<2> merged(mergedSegments(box(17)));
    ASSERT_EQ(merged.size(), 4u);
    scalar length = 0;
    for (const nscd::Segment& s : merged)
    {
        length += (s.b - s.a).norm();
    }
    EXPECT_NEAR(length, 8, 1e-14);
}


TEST(MergedSegments, DoNotDependOnOrderAndDirection)
{
    nscd::Walls<2> walls(box(9));
    const nscd::Walls<2> reference(mergedSegments(walls));
    std::mt19937 random(1);
    for (int trial = 0; trial < 20; ++trial)
    {
        std::shuffle(walls.begin(), walls.end(), random);
        for (nscd::Segment& s : walls)
        {
            if (random() % 2)
            {
                std::swap(s.a, s.b);
            }
        }
        EXPECT_TRUE(same(mergedSegments(walls), reference));
    }
}


TEST(MergedSegments, KeepMaterialsApart)
{
    nscd::Walls<2> walls(box(4));
    walls[1].material = 1;      // within the bottom
    EXPECT_EQ(mergedSegments(walls).size(), 6u);
}


TEST(MergedSegments, KeepBendsGapsAndBranches)
{
    EXPECT_EQ(mergedSegments({{{0, 0}, {1, 0}, 0}, {{1, 0}, {2, 0.001}, 0}}).size(), 2u);
    EXPECT_EQ(mergedSegments({{{0, 0}, {1, 0}, 0}, {{1.1, 0}, {2, 0}, 0}}).size(), 2u);
    EXPECT_EQ
    (
        mergedSegments({{{0, 0}, {1, 0}, 0}, {{1, 0}, {2, 0}, 0}, {{1, 0}, {1, 1}, 0}}).size(), 3u
    );
    EXPECT_TRUE(mergedSegments({}).empty());
}


TEST(MergedSegments, FollowALineThatTurnsBack)
{
    // Two pieces on top of each other are no straight continuation
    EXPECT_EQ(mergedSegments({{{0, 0}, {2, 0}, 0}, {{2, 0}, {1, 0}, 0}}).size(), 2u);
}
