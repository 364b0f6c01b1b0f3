// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The tree of boxes against all boxes.

#include "nscd/base/Random.hpp"
#include "nscd/search/BoxTree.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace
{

template <int D>
nscd::Bounds<D> randomBox(nscd::Random& random)
{
    nscd::Bounds<D> box;
    for (int d = 0; d < D; ++d)
    {
        box.lower[d] = random.uniform(-5, 5);
        box.upper[d] = box.lower[d] + random.uniform(0, 0.5);
    }
    return box;
}

template <int D>
void expectAllMeeting(int number, int groups)
{
    nscd::Random random(number + groups);
    std::vector<nscd::Bounds<D>> boxes;
    std::vector<int> group;
    for (int i = 0; i < number; ++i)
    {
        boxes.push_back(i % 7 == 3 ? boxes.back() : randomBox<D>(random));   // some coincide
        group.push_back(static_cast<int>(random.uniform(0, groups)));
    }
    nscd::BoxTree<D> tree(boxes, group);
    for (int move = 0; move < 3; ++move)
    {
        for (int i = 0; i < 100; ++i)
        {
            const nscd::Bounds<D> box = randomBox<D>(random);
            std::vector<int> found, expected;
            tree.forMeeting(box, [&](int b) { found.push_back(b); });
            std::sort(found.begin(), found.end());
            for (int b = 0; b < number; ++b)
            {
                if (boxes[b].meets(box))
                {
                    expected.push_back(b);
                }
            }
            EXPECT_EQ(found, expected);
        }
        for (nscd::Bounds<D>& box : boxes)
        {
            box = randomBox<D>(random);
        }
        tree.refit(boxes);
    }
}

}  // namespace

TEST(BoxTree, FindsAllBoxesThatMeetAGivenOne)
{
    for (const int number : {0, 1, 4, 5, 300})
    {
        expectAllMeeting<2>(number, 1);
        expectAllMeeting<3>(number, 1);
        expectAllMeeting<3>(number, 3);
    }
}

TEST(BoxTree, TellsThemInTheSameOrderAfterBoxesHaveMoved)
{
    nscd::Random random(1);
    std::vector<nscd::Bounds<3>> boxes;
    for (int i = 0; i < 100; ++i)
    {
        boxes.push_back(randomBox<3>(random));
    }
    nscd::BoxTree<3> tree(boxes, std::vector<int>(100, 0));
    const nscd::Bounds<3> everywhere{nscd::Vector<3>::Constant(-10), nscd::Vector<3>::Constant(10)};
    std::vector<int> before, after;
    tree.forMeeting(everywhere, [&](int b) { before.push_back(b); });
    for (nscd::Bounds<3>& box : boxes)
    {
        box = randomBox<3>(random);
    }
    tree.refit(boxes);
    tree.forMeeting(everywhere, [&](int b) { after.push_back(b); });
    EXPECT_EQ(before.size(), 100u);
    EXPECT_EQ(before, after);
}
