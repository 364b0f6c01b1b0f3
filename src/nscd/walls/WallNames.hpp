// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace nscd
{

/// Names by which a state finds walls and their bodies again, in whatever order they are.
struct WallNames
{
    std::vector<std::string> entries;   ///< without line breaks; none: walls are known by their number
    std::vector<int> ofWall;            ///< of each wall, an index into the entries
    std::vector<int> ofBody;            ///< of each wall body, an index into the entries
};

}  // namespace nscd
