// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/walls/Walls.hpp"

namespace nscd
{

/// The way of a wall body's points from its initial to another place; the identity, to the last bit, if it has not
/// moved.
template <int D>
struct RigidMotion
{
    using Matrix = Eigen::Matrix<double, D, D>;

    RigidMotion(const WallBody<D>& initial, const WallBody<D>& now)
        : centre(initial.position), shift(now.position - initial.position),
          turn((now.orientation.toRotationMatrix() - initial.orientation.toRotationMatrix()) *
               initial.orientation.toRotationMatrix().transpose())
    {
    }

    Vector<D> operator()(const Vector<D>& x) const { return x + (turn * (x - centre) + shift); }

    bool operator==(const RigidMotion& other) const
    {
        return centre == other.centre && shift == other.shift && turn == other.turn;
    }

    Vector<D> centre, shift;
    Matrix turn;   ///< rotation matrix minus identity
};

/// Motions of all bodies.
template <int D>
std::vector<RigidMotion<D>> rigidMotions(const std::vector<WallBody<D>>& initial, const std::vector<WallBody<D>>& now)
{
    std::vector<RigidMotion<D>> motions;
    for (std::size_t b = 0; b < initial.size(); ++b)
    {
        motions.emplace_back(initial[b], now[b]);
    }
    return motions;
}

}  // namespace nscd
