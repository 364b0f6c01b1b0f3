// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Check.hpp"
#include "nscd/base/Types.hpp"

#include <algorithm>
#include <cmath>

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
/// A moment of inertia that is infinite keeps the spin about the axes that are left.
inline void turn(Orientation<3>& orientation, Spin<3>& spin, const Spin<3>& inertia, double dt)
{
    if (!isFinite(inertia))
    {
        orientation = turned(orientation, spin, dt);
        return;
    }
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

}  // namespace nscd
