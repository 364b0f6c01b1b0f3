// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/Types.hpp"

namespace nscd
{

/// The shape of a rigid cluster of discs or spheres, which may overlap, in its own frame: the origin is the centre of
/// mass, the axes are the principal ones, and the circle or sphere around the origin that holds it has radius 1.
/// A grain of radius R is this shape times R.
template <int D>
struct Cluster
{
    Vectors<D> centre;
    std::vector<double> radius;
    double volume = 0;    ///< of the union
    Spin<D> inertia;      ///< principal moments over the mass, of the uniformly filled union
};

/// The cluster of the given discs or spheres [m], whatever their frame.  'size' (if not null) receives the radius [m]
/// of the circle or sphere around the centre of mass that holds all of them.  Volume and inertia are those of the
/// union, without counting overlaps twice, to about 1e-5.  Throws std::invalid_argument for an empty list, lists of
/// different length, and radii that are not positive.
template <int D>
Cluster<D> makeCluster(const Vectors<D>& centres, const std::vector<double>& radii, double* size = nullptr);

}  // namespace nscd
