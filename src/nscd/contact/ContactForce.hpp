// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

namespace nscd
{

/// A contact that carried an impulse in the last sub-step.
template <int D>
struct ContactForce
{
    int first, second;   ///< grains; second < 0: wall ~second
    Vector<D> point;     ///< in the middle of gap or overlap [m]
    Vector<D> normal;    ///< from the first to the second
    Vector<D> force;     ///< on the second: impulse over the sub-step [N]
    double gap;          ///< [m], at the beginning of the sub-step
    double pressing;     ///< with which the surfaces press on each other >= 0 [N]: what the normal part of the force
                         ///< and the attraction of a cohesive contact add up to
    Spin<D> moment = Spin<D>::Zero();   ///< of rolling, on the second, besides the force's [N m]
};

/// What a contact, or the impacts at it, gave a wall in a sub-step.
template <int D>
struct WallImpulse
{
    int wall;
    Vector<D> point;     ///< where the contact is at the end of the sub-step [m]
    Vector<D> impulse;   ///< [N s]
    Spin<D> moment;      ///< of rolling, besides the impulse's [N m s]
};

/// A pair that touched in a sub-step: what passes between the two meanwhile asks for it.
template <int D>
struct Touching
{
    int first, second;   ///< grains; second < 0: wall ~second
    Vector<D> point;     ///< in the middle of gap or overlap [m]
    double pressed;      ///< sum of the normal impulses with which the surfaces pressed on each other >= 0 [N s]
    double time;         ///< in which they did [s]; 0: in impacts, each of its own short time
    int impacts;
};

}  // namespace nscd
