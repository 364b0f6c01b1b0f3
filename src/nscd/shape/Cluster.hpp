// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

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
    double volume = 0;  ///< of the union
    Spin<D> inertia;    ///< principal moments over the mass, of the uniformly filled union
};

/// A cluster, and where it lies in the frame of the discs or spheres that it was made from: a point x of the shape is
/// position + orientation * (size * x) there.
template <int D>
struct PlacedCluster
{
    Cluster<D> shape;
    double size;         ///< radius of the circle or sphere around the centre of mass that holds all members [m]
    Vector<D> position;  ///< centre of mass [m]
    Orientation<D> orientation;
};

/// The cluster of the given discs or spheres [m], whatever their frame.  Volume and inertia are those of the union,
/// without counting overlaps twice, to about 1e-8.  The principal axes are those nearest to the given frame's, so that
/// a body whose symmetry follows the frame keeps its directions; a member that lies within another is left out.
/// Throws std::invalid_argument for an empty list, lists of different length, centres that are not finite, and radii
/// that are not positive.
template <int D>
PlacedCluster<D> placedCluster(const Vectors<D>& centres, const std::vector<double>& radii);

/// Its shape alone; 'size' (if not null) receives its size [m].
template <int D>
Cluster<D> makeCluster(const Vectors<D>& centres, const std::vector<double>& radii, double* size = nullptr);

/// An elongated grain along its x axis: equal discs or spheres in a row, equally spaced, of the given ratio of length
/// to width (Coppin et al., Phys. Rev. Fluids 2023, for discs).  One member if the ratio is 1.  Throws
/// std::invalid_argument unless 1 <= aspectRatio <= members, beyond which they would not hold together.
template <int D>
Cluster<D> makeRod(int members, double aspectRatio);

}  // namespace nscd
