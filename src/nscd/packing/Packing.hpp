// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/dynamics/ContactDynamics.hpp"

#include <functional>

namespace nscd
{

/// An axis-aligned box within which grains lie wholly [m].
template <int D>
struct Box
{
    Vector<D> lower, upper;

    /// [m^D]
    double volume() const { return (upper - lower).prod(); }
};

/// Throws std::invalid_argument unless lower < upper along every axis.
template <int D>
void checkBox(const Box<D>& box);

/// Centres of a square (cubic) lattice that starts in the box's lower corner, x fastest; distance between neighbours
/// spacing >= 2 radius [m].  Throws std::invalid_argument for an empty box, radius <= 0 or spacing < 2 radius.
template <int D>
Vectors<D> lattice(const Box<D>& box, double radius, double spacing);

/// Centres of the densest lattice, neighbours 2 radius + gap apart, rows parallel to x, starting in the lower corner:
/// triangular in 2-D (solid fraction pi/sqrt(12)), face-centred cubic with close-packed layers normal to z in 3-D
/// (pi/sqrt(18)).  Throws std::invalid_argument for an empty box, radius <= 0 or gap < 0.
template <int D>
Vectors<D> hexagonal(const Box<D>& box, double radius, double gap = 0);

/// Random sequential insertion without overlaps: centres of grains with the given radii [m], entry by entry, the
/// largest placed first.  The same for a seed on every platform.  Throws std::invalid_argument for an empty box,
/// radii <= 0 or a grain wider than the box, and std::runtime_error when a grain finds no place in maxTries draws
/// (the solid fraction that can be reached is about 0.54 in 2-D and 0.38 in 3-D for equal grains).  A grain of a centre
/// and radius that 'accepts' is there for and returns false tries another place.
template <int D>
Vectors<D> randomFill(const Box<D>& box, const std::vector<double>& radii, std::uint64_t seed, int maxTries = 10000,
                      const std::function<bool(const Vector<D>&, double)>& accepts = nullptr);

/// What settle() reached.
template <int D>
struct Settled
{
    Grains<D> grains;
    double time = 0;          ///< [s]
    double maxVelocity = 0;   ///< in the last step [m/s]
    bool atRest = false;      ///< or else maxTime was over
};

/// Let dry grains fall under gravity [m/s^2] until none has been faster than 'atRest' [m/s] for five times the time
/// in which it would fall by a mean radius, or until 'maxTime' [s], in steps of dt [s].  So long because a grain on top
/// of its way, or one that begins to tip over another, is slow too.  After every step 'report' is told the time [s],
/// the velocity of the fastest [m/s] and the grains.  Throws std::invalid_argument.
template <int D>
Settled<D> settle(ContactDynamics<D> dynamics, const Vector<D>& gravity, double dt, double atRest, double maxTime,
                  const std::function<void(double, double, const Grains<D>&)>& report = nullptr);

}  // namespace nscd
