// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/dynamics/State.hpp"

namespace nscd
{

/// Bring walls of a state into the order of others, by their names.  A body that the state does not have is at its
/// initial place; impulses at walls that are not there any more, or in other pieces, are left out.  States and walls
/// without names have the same order.  Throws std::runtime_error if a wall that the state has moved cannot move now.
template <int D>
void renumberWalls(State<D>& state, const WallNames& names, const std::vector<WallBody<D>>& initial,
                   const std::string& file);

}  // namespace nscd
