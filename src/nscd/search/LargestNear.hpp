// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/search/CellGrid.hpp"

namespace nscd
{

/// For each point [m] the largest of the values >= 0 at all points that are nearer than 'side' [m], and of some that
/// are not: in its cell of that side > 0 and those around it.
template <int D>
std::vector<double> largestNear(const Vectors<D>& points, const std::vector<double>& values, double side)
{
    if (points.empty())
    {
        return {};
    }
    const CellGrid<D> grid(points, side);
    const std::vector<int>&begin = grid.begin(), &members = grid.members();
    std::vector<double> largestIn(grid.cells(), 0.0), result(points.size());
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
    {
        for (int m = begin[cell]; m < begin[cell + 1]; ++m)
        {
            largestIn[cell] = std::max(largestIn[cell], values[members[m]]);
        }
    }
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
    {
        if (begin[cell] == begin[cell + 1])
        {
            continue;
        }
        auto first = grid.coordinates(points[members[begin[cell]]]), last = first;
        for (int d = 0; d < D; ++d)
        {
            --first[d];
            ++last[d];
        }
        double largest = 0;
        grid.forCells(first, last, [&](std::size_t near) { largest = std::max(largest, largestIn[near]); });
        for (int m = begin[cell]; m < begin[cell + 1]; ++m)
        {
            result[members[m]] = largest;
        }
    }
    return result;
}

}  // namespace nscd
