// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace nscd
{

/// The plane of a wall, seen from the centre of a grain near it.
template <int D>
struct NearPlane
{
    int wall;
    double distance;    ///< [m]
    Vector<D> normal;   ///< from the centre to the wall, of unit length
};

/// Of a plane in one direction from the foot of its normal: where its own part begins and ends [m]; none if it ends
/// before it begins.
struct Stretch
{
    double weight;   ///< of the direction; their sum is 1
    double from = 0, to = std::numeric_limits<double>::infinity();
};

/// What is between planes around a grain has a face on each of them, cut off by the others.  The face of one, not
/// farther than 'farthest' [m] from the centre, in directions around the foot; empty: the others cut off
/// nothing; no value: they leave nothing.  Of planes that are the same one, the first has all.
template <int D>
std::optional<std::vector<Stretch>> ownPart(const std::vector<NearPlane<D>>& planes, std::size_t own, double farthest);

/// What of law(r), a sum out to the distance r from the foot [m], falls to the own part.
template <class Law>
double ofOwnPart(const std::vector<Stretch>& own, Law&& law)
{
    if (own.empty())
    {
        return law(std::numeric_limits<double>::infinity());
    }
    double sum = 0;
    for (const Stretch& stretch : own)
    {
        sum += stretch.to > stretch.from ? stretch.weight * (law(stretch.to) - law(stretch.from)) : 0;
    }
    return sum;
}

}  // namespace nscd
