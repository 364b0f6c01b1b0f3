// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace nscd
{

/// Indices of points so that neighbours in space are near each other in the list: layer by layer of a given thickness
/// [m], > 0, along the last axis, in a layer row by row (3-D), in a row by the first coordinate.
template <int D>
std::vector<std::size_t> spatialOrder(const Vectors<D>& position, double thickness)
{
    const auto key = [&](std::size_t i)
    {
        std::array<double, D> k;
        for (int d = 1; d < D; ++d) k[D - 1 - d] = std::floor(position[i][d] / thickness);
        k[D - 1] = position[i][0];
        return k;
    };
    std::vector<std::size_t> order(position.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
    return order;
}

}  // namespace nscd
