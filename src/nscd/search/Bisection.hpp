// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

namespace nscd
{

/// Recursive coordinate bisection: the block, 0 <= b < blocks, of every point.  Blocks (a power of two) hold equal
/// numbers of points within one; each cut is across the longest extent.  A function of the positions alone.
template <int D>
std::vector<int> bisect(const Vectors<D>& points, int blocks);

}  // namespace nscd
