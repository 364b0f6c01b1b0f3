// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/Types.hpp"

namespace nscd
{

/// A fixed straight wall from a to b in 2-D; grains are stopped on either side.
/// Segments that share an end point form one smooth wall: a grain that slides over the
/// joint of two collinear segments does not feel it.
struct Segment
{
    Vector<2> a, b;
    int material = 0;
};

/// A fixed half space in 3-D: grains stay where (x - point).normal > 0.
struct Plane
{
    Vector<3> point, normal;   ///< the normal is of unit length
    int material = 0;
};

template <int D>
struct WallOf;

template <>
struct WallOf<2>
{
    using type = Segment;
};

template <>
struct WallOf<3>
{
    using type = Plane;
};

template <int D>
using Walls = std::vector<typename WallOf<D>::type>;

}  // namespace nscd
