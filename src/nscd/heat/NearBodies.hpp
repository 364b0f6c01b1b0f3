// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/heat/OwnPart.hpp"
#include "nscd/shape/Grains.hpp"
#include "nscd/walls/WallContact.hpp"

namespace nscd
{

/// Two grains near each other, first < second; a grain and a periodic image of itself, first = second; or a grain and
/// wall ~second.
struct NearBodies
{
    int first, second;
    double distance;   ///< between centres, or of the centre from the wall [m]

    /// Of a wall, of what its plane would have alone (ownPart); empty: all.
    std::vector<Stretch> own = {};
};

/// Grains whose centres are nearer than 'reach' times the sum of their radii, and walls nearer to a centre than 'reach'
/// diameters of the grain.  A function of the positions alone.  Bodies with the facet of another wall between them are
/// not near.  Facets of a wall that is flat or convex there count once, those of a hollow with their own part each.
/// In a box that is narrower than the reach, periods in [m], a pair counts once for each image.
template <int D>
std::vector<NearBodies> nearBodies(const Grains<D>& grains, const WallContact<D>& walls, double reach,
                                   const std::array<double, 3>& period);

}  // namespace nscd
