// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Rotation.hpp"
#include "nscd/contact/LeveredContact.hpp"
#include "nscd/shape/Grains.hpp"
#include "nscd/walls/Walls.hpp"

namespace nscd
{

/// Principal moments of inertia of a grain over its mass and the square of its radius.
template <int D>
Spin<D> shapeInertia(const Grains<D>& grains, std::size_t i)
{
    return grains.shape[i] < 0 ? Spin<D>(Spin<D>::Constant(inertiaFactor<D>))
                               : grains.clusters[grains.shape[i]].inertia;
}

/// Moment of inertia times a spin [N m s].
template <int D>
Spin<D> angularMomentum(const Grains<D>& grains, std::size_t i, const Spin<D>& spin)
{
    const double scale = grains.mass[i] * grains.radius[i] * grains.radius[i];
    if (grains.shape[i] < 0)
    {
        return inertiaFactor<D> * scale * spin;
    }
    return scale * inSpace(grains.orientation[i], shapeInertia(grains, i)) * spin;
}

/// Spin of a grain of the given angular momentum and orientation.
template <int D>
Spin<D> spinOf(const Grains<D>& grains, std::size_t i, const Orientation<D>& orientation, const Spin<D>& momentum)
{
    const double scale = grains.mass[i] * grains.radius[i] * grains.radius[i];
    if (grains.shape[i] < 0)
    {
        return momentum / (inertiaFactor<D> * scale);
    }
    return inSpace(orientation, shapeInertia(grains, i).cwiseInverse()) * momentum / scale;
}

/// Angular momentum dot spin of a body with the given moments of inertia [J]; what cannot turn does not count.
inline double product(const Orientation<2>&, const Spin<2>& inertia, const Spin<2>& a, const Spin<2>& b)
{
    return std::isfinite(inertia[0]) ? inertia[0] * a[0] * b[0] : 0;
}

inline double product(const Orientation<3>& orientation, const Spin<3>& inertia, const Spin<3>& a, const Spin<3>& b)
{
    const Eigen::Matrix3d toBody = orientation.toRotationMatrix().transpose();
    const Vector<3> own = toBody * a, other = toBody * b;
    double sum = 0;
    for (int d = 0; d < 3; ++d)
    {
        sum += std::isfinite(inertia[d]) ? inertia[d] * own[d] * other[d] : 0;
    }
    return sum;
}

/// How a grain that is as many times as heavy turns, for the contact problem.
template <int D>
Turning<D> turningOf(const Grains<D>& grains, std::size_t i, double heaviness = 1)
{
    const Spin<D> inverse = (heaviness * grains.mass[i] * shapeInertia(grains, i)).cwiseInverse();
    return {grains.radius[i], grains.shape[i] < 0 ? SpinMatrix<D>(inverse.asDiagonal())
                                                  : inSpace(grains.orientation[i], inverse)};
}

/// Speed of the surface of a grain, or of a point at a distance of 'radius', due to spin [m/s].
template <int D>
Tangent<D> surfaceSpeed(const Spin<D>& spin, double radius)
{
    if constexpr (D == 2)
    {
        return radius * spin[0];
    }
    else
    {
        return radius * spin;
    }
}

/// Motion of a free wall body under its load alone.
template <int D>
struct FreeWall
{
    FreeWall(const WallBody<D>& wall, double dt)
        : turning{1, inSpace(wall.orientation, Spin<D>(wall.inertia.cwiseInverse()))},
          velocity(wall.velocity + dt / wall.mass * wall.force),
          spin(wall.spin + dt * turning.inverse * wall.torque)
    {
    }

    Turning<D> turning;
    Vector<D> velocity;
    Spin<D> spin;
};

/// Turn a grain by its spin over dt.  The angular momentum stays, and with it the spin of a disc or sphere.
template <int D>
void turn(Grains<D>& grains, std::size_t i, double dt)
{
    Orientation<D>& orientation = grains.orientation[i];
    if (grains.shape[i] < 0)
    {
        orientation = turned(orientation, grains.spin[i], dt);
        return;
    }
    turn(orientation, grains.spin[i], shapeInertia(grains, i), dt);
}

/// Turn a wall by its spin over dt; a free one keeps its angular momentum.
template <int D>
void turn(WallBody<D>& wall, double dt)
{
    turn(wall.orientation, wall.spin, wall.inertia, dt);
}

}  // namespace nscd
