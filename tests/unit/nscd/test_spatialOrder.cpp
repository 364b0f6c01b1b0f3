// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/search/SpatialOrder.hpp"

#include <gtest/gtest.h>

using namespace nscd;

TEST(SpatialOrder, RowByRowInThePlane)
{
    const Vectors<2> position{{3, 0.5}, {1, 1.5}, {2, 0.9}, {0, 1.1}, {-1, -0.5}};

    EXPECT_EQ(spatialOrder<2>(position, 1), (std::vector<std::size_t>{4, 2, 0, 3, 1}));
}

TEST(SpatialOrder, LayersBeforeRowsInSpace)
{
    const Vectors<3> position{{1, 0, 1.5}, {0, 1.5, 0}, {5, 0, 0}, {4, 0.9, 0.9}};

    EXPECT_EQ(spatialOrder<3>(position, 1), (std::vector<std::size_t>{3, 2, 1, 0}));
}
