// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <vector>

namespace nscd
{

/// Where a grain is pressed on a wall.
template <int D>
struct ContactPatch
{
    int grain, wall;
    Vector<D> point;    ///< its middle [m]
    double radius;      ///< or half width, of this contact alone [m]
    double force;       ///< while it lasts [N]
    double meanForce;   ///< over the time step [N]
};

/// The force on each patch over that of its contact alone: patches of a grain on different facets that lie over each
/// other are one, with the sum of the forces.  What others add falls linearly with the distance, to nothing where
/// patches lie side by side.  A law's conductance for this force, divided by the factor, is the contact's share.
template <int D>
std::vector<double> joinedForces(const std::vector<ContactPatch<D>>& patches);

}  // namespace nscd
