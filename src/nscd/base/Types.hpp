// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

/// Non-smooth contact dynamics of rigid grains: SI units throughout, no mesh, no OpenFOAM.
namespace nscd
{

/// A point, a velocity [m/s] or a force [N] in D = 2 or 3 dimensions.
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

/// An angular velocity [rad/s] or a torque [N m]: one component in 2-D, three in 3-D.
template <int D>
using Spin = Eigen::Matrix<double, D == 2 ? 1 : 3, 1>;

template <int D>
using Vectors = std::vector<Vector<D>>;

template <int D>
using SpinMatrix = Eigen::Matrix<double, Spin<D>::RowsAtCompileTime, Spin<D>::RowsAtCompileTime>;

template <int D>
using Spins = std::vector<Spin<D>>;

/// A force [N] and a torque [N m] of each grain.
template <int D>
struct Wrenches
{
    Vectors<D> force;
    Spins<D> torque;
};

template <int D>
struct OrientationOf
{
    using type = Eigen::Quaterniond;
};

template <>
struct OrientationOf<2>
{
    using type = Eigen::Rotation2Dd;
};

/// Rotation from the body's frame to space: an angle in 2-D, a unit quaternion in 3-D.
template <int D>
using Orientation = typename OrientationOf<D>::type;

template <int D>
using Orientations = std::vector<Orientation<D>>;

/// Moment of inertia over m r^2: a solid disc (2-D) 1/2, a solid sphere (3-D) 2/5.
template <int D>
constexpr double inertiaFactor = D == 2 ? 0.5 : 0.4;

}  // namespace nscd
