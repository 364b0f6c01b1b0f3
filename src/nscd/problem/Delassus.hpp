// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/LeveredContact.hpp"
#include "nscd/problem/SparseProblem.hpp"

namespace nscd
{

/// A rigid body of any shape with the velocity it would have at the end of the step without contacts.
template <int D>
struct RigidBody
{
    Vector<D> position;            ///< centre of mass [m]
    Vector<D> velocity;            ///< [m/s]
    Spin<D> spin;                  ///< [rad/s]
    double inverseMass;            ///< 0: not moved by contacts [1/kg]
    SpinMatrix<D> inverseInertia;  ///< in space, about the centre of mass [1/(kg m^2)]
};

/// Where two bodies touch, or may within the step.
template <int D>
struct ContactPoint
{
    int first, second;  ///< bodies
    Vector<D> point;    ///< [m]
    Vector<D> normal;   ///< unit vector from the first body to the second
    double approach;    ///< normal velocity that they may keep: gap over time step [m/s]
    double friction;

    /// Displacement of the second body's periodic image [m].
    Vector<D> shift = Vector<D>::Zero();
};

/// The contact problem of rigid bodies, u = W r + q:  u is the velocity of the second body against the first at the
/// contact point in contactFrame(normal), plus 'approach' along the normal;  W = H^T M^-1 H with the generalised
/// directions H of the impulses r on the second body, and q = H^T v + approach.
/// Throws std::invalid_argument for a contact of bodies that are not there or are all fixed.
template <int D>
SparseProblem<D> delassus(const std::vector<RigidBody<D>>& bodies, const std::vector<ContactPoint<D>>& contacts);

/// Velocities and spins after the impulses: v + M^-1 H r.
template <int D>
std::vector<RigidBody<D>> withImpulses(std::vector<RigidBody<D>> bodies, const std::vector<ContactPoint<D>>& contacts,
                                       const Vectors<D>& r);

}  // namespace nscd
