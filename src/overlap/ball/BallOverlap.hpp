// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/Types.hpp"

namespace overlap
{

/// Intersection of a ball with a polyhedral cell.
struct BallOverlap
{
    double volume = 0;                     ///< [m^3]
    Point3 centroid = Point3::Zero();      ///< [m], the ball's centre if there is no overlap
    double wettedArea = 0;                 ///< area of the ball's surface within the cell [m^2]
    Point3 wettedVector = Point3::Zero();  ///< integral of the ball's outward normal over that surface [m^2]
};

}  // namespace overlap
