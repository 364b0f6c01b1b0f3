// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace nscd
{

/// A straight wall from a to b in 2-D; grains are stopped on either side.
/// Segments that share an end point form one smooth wall: a grain that slides over the
/// joint of two collinear segments does not feel it.
struct Segment
{
    Vector<2> a, b;
    int material = 0;
    int body = -1;   ///< index of the wall body it moves with; -1: fixed
};

/// A half space in 3-D: grains stay where (x - point).normal > 0.
struct Plane
{
    Vector<3> point, normal;   ///< the normal is of unit length
    int material = 0;
    int body = -1;
};

/// A triangle in 3-D; grains are stopped on either side.
/// Triangles that share an edge or a corner form one smooth wall.
struct Triangle
{
    Vector<3> a, b, c;
    int material = 0;
    int body = -1;
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
    using type = std::variant<Plane, Triangle>;
};

inline int materialOf(const Segment& wall) { return wall.material; }
inline int bodyOf(const Segment& wall) { return wall.body; }

inline void setMaterial(Segment& wall, int material) { wall.material = material; }

inline void setMaterial(std::variant<Plane, Triangle>& wall, int material)
{
    std::visit([material](auto& w) { w.material = material; }, wall);
}

inline int materialOf(const std::variant<Plane, Triangle>& wall)
{
    return std::visit([](const auto& w) { return w.material; }, wall);
}

inline int bodyOf(const std::variant<Plane, Triangle>& wall)
{
    return std::visit([](const auto& w) { return w.body; }, wall);
}

/// Distance of the farthest point of a wall from a point [m]; a half space only moves along.
inline double extentFrom(const Segment& wall, const Vector<2>& x)
{
    return std::max((wall.a - x).norm(), (wall.b - x).norm());
}

inline double extentFrom(const std::variant<Plane, Triangle>& wall, const Vector<3>& x)
{
    const Triangle* t = std::get_if<Triangle>(&wall);
    return t ? std::max({(t->a - x).norm(), (t->b - x).norm(), (t->c - x).norm()}) : 0;
}

/// Walls where they stand when their bodies are at their initial place.
template <int D>
using Walls = std::vector<typename WallOf<D>::type>;

/// Walls that move as one: v(x) = velocity + spin x (x - position).
template <int D>
struct WallBody
{
    Vector<D> position = Vector<D>::Zero();   ///< what it turns about; of a free body the centre of mass [m]
    Orientation<D> orientation = Orientation<D>::Identity();   ///< the identity at the initial place
    Vector<D> velocity = Vector<D>::Zero();                    ///< [m/s]
    Spin<D> spin = Spin<D>::Zero();                            ///< in space [rad/s]

    /// Mass [kg] and moments of inertia about space's axes at the initial place [kg m^2] of a body that moves freely;
    /// infinite where the motion is prescribed.  A free piston has a finite mass and infinite moments.
    double mass = std::numeric_limits<double>::infinity();
    Spin<D> inertia = Spin<D>::Constant(std::numeric_limits<double>::infinity());

    Vector<D> force = Vector<D>::Zero();   ///< on a free body [N]
    Spin<D> torque = Spin<D>::Zero();      ///< [N m]
};

}  // namespace nscd
