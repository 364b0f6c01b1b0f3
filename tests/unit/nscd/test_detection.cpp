// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Candidates against all pairs, blocks, and the rounds between blocks.

#include "Scene.hpp"

#include "nscd/contact/Schedule.hpp"
#include "nscd/search/Bisection.hpp"

#include <gtest/gtest.h>
#include <set>

namespace
{

nscd::Reach uniform(std::size_t grains, double ofGrain, double ofWalls)
{
    return {std::vector<double>(grains, ofGrain), ofWalls};
}

/// Candidates of discs or spheres at x among walls.
template <int D>
nscd::Candidates<D> candidatesOf(const nscd::Vectors<D>& x, const std::vector<double>& radius,
                                 const nscd::WallContact<D>& walls, std::size_t wallCount, const nscd::Reach& reach,
                                 std::array<double, 3> period = {0, 0, 0})
{
    nscd::Grains<D> grains;
    grains.resize(x.size());
    grains.position = x;
    grains.radius = radius;
    const nscd::Members<D> members(grains);
    const std::vector<int> noFreeBody(wallCount, -1);
    const nscd::Communicator communicator(MPI_COMM_SELF);
    return {{members, walls, noFreeBody, 0, reach, 8, period, {}}, x, grains.orientation, communicator};
}

template <int D>
void expectAllNearPairs(double smallest, double stray)
{
    nscd::Random random(3);
    nscd::Vectors<D> x;
    std::vector<double> radius;
    for (int i = 0; i < 400; ++i)
    {
        nscd::Vector<D> p;
        for (int d = 0; d < D; ++d)
        {
            p[d] = random.uniform(-7, 9);
        }
        x.push_back(p);
        radius.push_back(std::exp(random.uniform(std::log(smallest), 0.0)));
    }
    x[5][0] = stray;
    std::vector<double> reach;
    for (int i = 0; i < 400; ++i)
    {
        reach.push_back(i % 50 == 0 ? 1.5 : random.uniform(0, 0.2));
    }
    const nscd::Candidates<D> candidates = candidatesOf<D>(x, radius, nscd::WallContact<D>({}), 0, {reach, 0});

    std::multiset<std::pair<int, int>> found;
    for (const nscd::Pair& pair : candidates.pairs())
    {
        EXPECT_LT(pair.first, pair.second);
        found.insert(std::minmax(candidates.order()[pair.first], candidates.order()[pair.second]));
    }
    std::multiset<std::pair<int, int>> expected;
    for (int i = 0; i < 400; ++i)
    {
        for (int j = i + 1; j < 400; ++j)
        {
            if ((x[i] - x[j]).norm() < radius[i] + reach[i] + radius[j] + reach[j])
            {
                expected.insert({i, j});
            }
        }
    }
    EXPECT_GT(expected.size(), 20u);
    EXPECT_EQ(found, expected);
}

}  // namespace

TEST(Candidates, AreAllPairsWithinTheirReaches)
{
    expectAllNearPairs<2>(0.5, 0);
    expectAllNearPairs<3>(0.5, 0);
}

TEST(Candidates, AreCompleteForAWideRangeOfSizesAndStrayGrains)
{
    expectAllNearPairs<2>(0.01, 1e7);
    expectAllNearPairs<3>(0.01, -1e20);
}

TEST(Candidates, OfANarrowPeriodicBoxAreListedOnce)
{
    // Either grain sees the other one on both sides; contacts are those of the nearest image
    const nscd::Vectors<2> x{{0.5, 0}, {2.7, 0.1}, {1.6, 1.9}};
    const nscd::Candidates<2> candidates =
        candidatesOf<2>(x, std::vector<double>(3, 1), nscd::WallContact<2>({}), 0, uniform(3, 0.5, 0), {4.4, 0, 0});
    std::multiset<std::pair<int, int>> found;
    for (const nscd::Pair& pair : candidates.pairs())
    {
        found.insert(std::minmax(candidates.order()[pair.first], candidates.order()[pair.second]));
    }
    EXPECT_EQ(found, (std::multiset<std::pair<int, int>>{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(Candidates, ContainNearWallsOnly)
{
    nscd::Walls<2> walls;
    for (int i = 0; i < 100; ++i)
    {
        walls.push_back({{i * 1.0, 0.3 * i}, {i + 1.0, 0.3 * i + 0.3}, 0});
    }
    nscd::Random random(5);
    nscd::Vectors<2> x;
    for (int i = 0; i < 500; ++i)
    {
        x.push_back({random.uniform(-5, 105), random.uniform(-5, 40)});
    }
    const nscd::WallContact<2> shapes(walls);
    const nscd::Candidates<2> candidates =
        candidatesOf<2>(x, std::vector<double>(500, 0.6), shapes, 100, uniform(500, 0.1, 0.2));
    std::multiset<std::pair<int, int>> found, expected;
    for (const nscd::Pair& pair : candidates.pairs())
    {
        if (pair.second < 0)
        {
            found.insert({candidates.order()[pair.first], ~pair.second});
        }
    }
    for (int i = 0; i < 500; ++i)
    {
        for (int w = 0; w < 100; ++w)
        {
            if (shapes.distance(w, x[i]) < 0.9)
            {
                expected.insert({i, w});
            }
        }
    }
    EXPECT_GT(expected.size(), 20u);
    EXPECT_EQ(found, expected);
}

TEST(Candidates, CountTheWorkOfBlocks)
{
    nscd::Vectors<2> x;
    for (int i = 0; i < 16; ++i)
    {
        x.push_back({i * 1.0, 0.5});
    }
    const nscd::WallContact<2> floor({{{-1, 0}, {3.5, 0}, 0}});
    const nscd::Reach reach = uniform(16, 0.05, 0.05);
    const std::vector<double> work = candidatesOf<2>(x, std::vector<double>(16, 0.5), floor, 1, reach).work();
    // Two discs to a block and four of them on the floor: pairs of two blocks are the lower one's
    EXPECT_GT(work[0], 2);
    EXPECT_EQ(work[1], work[0]);
    EXPECT_EQ(std::vector<double>(work.begin() + 2, work.end()), (std::vector<double>{2, 2, 2, 2, 2, 1}));
}

TEST(Candidates, AreDealtByWork)
{
    EXPECT_EQ(nscd::deal({1, 1, 1, 1}, 2), (std::vector<int>{0, 0, 1, 1}));
    EXPECT_EQ(nscd::deal({0, 0, 0, 0}, 2), (std::vector<int>{0, 0, 1, 1}));
    EXPECT_EQ(nscd::deal({4, 2, 1, 1}, 2), (std::vector<int>{0, 1, 1, 1}));
    EXPECT_EQ(nscd::deal({0, 0, 1, 9}, 2), (std::vector<int>{0, 0, 0, 1}));
    EXPECT_EQ(nscd::deal({1, 1}, 1), (std::vector<int>{0, 0}));
    EXPECT_EQ(nscd::deal({9, 0}, 4).back(), 3);
}

TEST(Bisection, MakesBlocksOfEqualSizeAlsoOfEqualPositions)
{
    nscd::Vectors<2> x(1001, nscd::Vector<2>(1, 1));
    for (int i = 0; i < 500; ++i)
    {
        x[i].x() = i % 10;
    }
    std::vector<int> count(8, 0);
    for (const int block : nscd::bisect<2>(x, 8))
    {
        ++count[block];
    }
    for (const int n : count)
    {
        EXPECT_NEAR(n, 1001 / 8.0, 1);
    }
}

TEST(Rounds, NeverUseABlockTwice)
{
    std::vector<std::pair<int, int>> edges;
    for (int a = 0; a < 8; ++a)
    {
        for (int b = a + 1; b < 8; ++b)
        {
            edges.emplace_back(a, b);
        }
    }
    std::size_t total = 0;
    for (const auto& round : nscd::colourEdges(edges, 8))
    {
        std::set<int> used;
        for (const auto& [a, b] : round)
        {
            EXPECT_TRUE(used.insert(a).second);
            EXPECT_TRUE(used.insert(b).second);
        }
        total += round.size();
    }
    EXPECT_EQ(total, edges.size());
}
