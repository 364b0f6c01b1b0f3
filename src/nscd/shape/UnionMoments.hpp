// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

namespace nscd
{

/// Moments of a body of density 1 about the origin.
template <int D>
struct Moments
{
    double volume = 0;                                                         ///< [m^D]
    Vector<D> first = Vector<D>::Zero();                                       ///< of x [m^(D+1)]
    Eigen::Matrix<double, D, D> second = Eigen::Matrix<double, D, D>::Zero();  ///< of x x^T [m^(D+2)]
};

/// Moments of the union of discs or spheres, overlaps counted once.  Discs: to round-off, from the arcs that bound the
/// union.  Spheres: the discs of their cross-sections, integrated by Gauss's rule between the heights at which the
/// cross-section changes its topology; about 1e-8 (doc/theory, eq. 5.19).  Radii must be > 0.
template <int D>
Moments<D> unionMoments(const Vectors<D>& centres, const std::vector<double>& radii);

}  // namespace nscd
