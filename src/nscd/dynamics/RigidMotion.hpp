// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Check.hpp"
#include "nscd/contact/LeveredContact.hpp"
#include "nscd/shape/Grains.hpp"
#include "nscd/walls/Walls.hpp"

namespace nscd
{

/// The rotation by spin * dt.
inline Orientation<2> rotation(const Spin<2>& spin, double dt)
{
    return Orientation<2>(dt * spin[0]);
}

inline Orientation<3> rotation(const Spin<3>& spin, double dt)
{
    const Vector<3> half = 0.5 * dt * spin;
    const double angle = half.norm();
    const double sinc = angle > 1e-4 ? std::sin(angle) / angle : 1 - angle * angle / 6;
    const Vector<3> v = sinc * half;
    return {std::cos(angle), v.x(), v.y(), v.z()};
}

inline Orientation<2> turned(const Orientation<2>& orientation, const Spin<2>& spin, double dt)
{
    return Orientation<2>(orientation.angle() + dt * spin[0]);
}

inline Orientation<3> turned(const Orientation<3>& orientation, const Spin<3>& spin, double dt)
{
    return (rotation(spin, dt) * orientation).normalized();
}

/// Largest distance that a point at unit distance moves when one orientation becomes the other.
inline double turnBetween(const Orientation<2>& a, const Orientation<2>& b)
{
    return std::min(2.0, std::abs(a.angle() - b.angle()));
}

inline double turnBetween(const Orientation<3>& a, const Orientation<3>& b)
{
    return 2 * (a.conjugate() * b).vec().norm();
}

/// A diagonal tensor of the body's frame, in space.
inline SpinMatrix<2> inSpace(const Orientation<2>&, const Spin<2>& diagonal)
{
    return diagonal;
}

inline SpinMatrix<3> inSpace(const Orientation<3>& orientation, const Spin<3>& diagonal)
{
    const Eigen::Matrix3d r = orientation.toRotationMatrix();
    return r * diagonal.asDiagonal() * r.transpose();
}

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

/// A spin that goes along with a body whose orientation changes.
inline Spin<2> carried(const Spin<2>& spin, const Orientation<2>&, const Orientation<2>&) { return spin; }

inline Spin<3> carried(const Spin<3>& spin, const Orientation<3>& from, const Orientation<3>& to)
{
    return to * (from.conjugate() * spin);
}

inline void turn(Orientation<2>& orientation, Spin<2>& spin, const Spin<2>&, double dt)
{
    orientation = turned(orientation, spin, dt);
}

/// Let a body turn freely over dt.  In its own frame, with principal moments of inertia I, its angular momentum is
///
///     L1 = exp(-dt W) L0,   W = (L0 + L1)/(2 I),
///
/// and the body turns by exp(dt W).  So L stays in space, and the energy, as L1.W = L0.W, both to round-off: the
/// implicit midpoint rule (Austin, Krishnaprasad and Wang 1993, doi:10.1006/jcph.1993.1128) with its rotation exact.
inline void turn(Orientation<3>& orientation, Spin<3>& spin, const Spin<3>& inertia, double dt)
{
    constexpr int most = 50;   // each gains a factor of the angle of the turn or more
    const Spin<3> own = orientation.conjugate() * spin;
    const Spin<3> momentum = inertia.cwiseProduct(own);
    Spin<3> end = own, mean = own;
    double change = 1;
    for (int k = 0; k < most && change > 1e-15 * own.norm(); ++k)
    {
        const Spin<3> last = end;
        mean = 0.5 * (own + end);
        end = (rotation(mean, -dt) * momentum).cwiseQuotient(inertia);
        change = (end - last).norm();
    }
    orientation = (orientation * rotation(mean, dt)).normalized();
    spin = orientation * end;
}

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

/// Turn a wall by its spin over dt.  A free one keeps its angular momentum; a moment of inertia that is infinite keeps
/// the spin about the axes that are left.
template <int D>
void turn(WallBody<D>& wall, double dt)
{
    if (!isFinite(wall.inertia))
    {
        wall.orientation = turned(wall.orientation, wall.spin, dt);
        return;
    }
    turn(wall.orientation, wall.spin, wall.inertia, dt);
}

}  // namespace nscd
