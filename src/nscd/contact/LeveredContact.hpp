// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Contact.hpp"
#include "nscd/contact/LocalSolve.hpp"

namespace nscd
{

/// How a body turns: its spin is held as surfaceSpeed = length * spin, and answers an angular impulse H with
/// surfaceSpeed += inverse * H / length.
template <int D>
struct Turning
{
    double length = 1;                                ///< [m]
    SpinMatrix<D> inverse = SpinMatrix<D>::Zero();    ///< length^2 times the inverse inertia in space [1/kg]
};

/// A contact whose force need not pass through the bodies' centres (clusters, free walls), or that resists rolling.
/// The local operator is full, and the rolling moment is one more unknown.
template <int D>
struct LeveredContact
{
    Block<D> frame;                    ///< columns: the normal from body i to body j, and tangents
    Vector<D> armI, armJ;              ///< from the bodies' centres to the contact, over their lengths
    Turning<D> turningI, turningJ;
    Block<D> w;                        ///< W in the frame [1/kg]
    double approachLimit;              ///< as in Contact
    double friction;
    double rollingLength;              ///< largest moment over the normal impulse [m]; 0 without resistance
    double rollingW;                   ///< bound of the rolling part of W [1/(kg m^2)]
    Vector<D> impulse;                 ///< on body j, in the frame [N s]
    Tangent<D> moment;                 ///< of rolling, on body j, in space [N m s]
    int i, j;

    Vector<D> normal() const { return frame.col(0); }
};

/// Columns: the normal and one or two tangents that make a right-handed frame with it.
inline Eigen::Matrix2d contactFrame(const Vector<2>& n)
{
    Eigen::Matrix2d frame;
    frame << n.x(), -n.y(), n.y(), n.x();
    return frame;
}

inline Eigen::Matrix3d contactFrame(const Vector<3>& n)
{
    Eigen::Matrix3d frame;
    frame.col(0) = n;
    frame.col(1) = n.unitOrthogonal();
    frame.col(2) = n.cross(frame.col(1));
    return frame;
}

/// Velocity of the end of an arm due to spin, and the moment of an impulse at it.
inline Vector<2> spinVelocity(double spin, const Vector<2>& arm) { return {-spin * arm.y(), spin * arm.x()}; }
inline Vector<3> spinVelocity(const Vector<3>& spin, const Vector<3>& arm) { return spin.cross(arm); }
inline Spin<2> momentOf(const Vector<2>& arm, const Vector<2>& p) { return Spin<2>(arm.x() * p.y() - arm.y() * p.x()); }
inline Spin<3> momentOf(const Vector<3>& arm, const Vector<3>& p) { return arm.cross(p); }

inline double toTangent(const Spin<2>& s) { return s[0]; }
inline Vector<3> toTangent(const Spin<3>& s) { return s; }
inline Spin<2> toSpin(double t) { return Spin<2>(t); }
inline Spin<3> toSpin(const Vector<3>& t) { return t; }

/// Velocity of body j against body i at the contact, in space [m/s].
template <int D>
Vector<D> relativeVelocity(const LeveredContact<D>& c, const Body<D>& a, const Body<D>& b)
{
    return b.velocity - a.velocity + spinVelocity(b.surfaceSpeed, c.armJ) - spinVelocity(a.surfaceSpeed, c.armI);
}

template <int D>
double normalVelocity(const LeveredContact<D>& c, const Body<D>& a, const Body<D>& b)
{
    return relativeVelocity(c, a, b).dot(c.normal());
}

/// The tangential part of the impulse, as Contact has it.
template <int D>
Tangent<D> tangential(const LeveredContact<D>& c)
{
    if constexpr (D == 2)
    {
        return c.impulse[1];
    }
    else
    {
        return c.frame.template rightCols<2>() * c.impulse.template tail<2>();
    }
}

/// Rate at which body j rolls over body i [rad/s].
template <int D>
Tangent<D> rollingRate(const LeveredContact<D>& c, const Body<D>& a, const Body<D>& b)
{
    const Tangent<D> rate = b.surfaceSpeed / c.turningJ.length - a.surfaceSpeed / c.turningI.length;
    if constexpr (D == 2)
    {
        return rate;
    }
    else
    {
        return rate - rate.dot(c.normal()) * c.normal();
    }
}

/// Change of the surface speed by an impulse at the end of an arm and a moment.
template <int D>
Tangent<D> answer(const Turning<D>& turning, const Vector<D>& arm, const Vector<D>& impulse, const Tangent<D>& moment)
{
    const Spin<D> total = momentOf(arm, impulse) + toSpin(Tangent<D>(moment / turning.length));
    return toTangent(Spin<D>(turning.inverse * total));
}

/// Give the bodies an impulse [N s] at the contact and a moment [N m s].
template <int D>
void apply(const LeveredContact<D>& c, Body<D>& a, Body<D>& b, const Vector<D>& impulse, const Tangent<D>& moment)
{
    a.velocity -= a.inverseMass * impulse;
    b.velocity += b.inverseMass * impulse;
    a.surfaceSpeed -= answer(c.turningI, c.armI, impulse, moment);
    b.surfaceSpeed += answer(c.turningJ, c.armJ, impulse, moment);
}

/// Fill in the local operators.
template <int D>
void assemble(LeveredContact<D>& c, double inverseMasses)
{
    const auto velocity = [](const Turning<D>& turning, const Vector<D>& arm, const Vector<D>& p)
    { return spinVelocity(answer(turning, arm, p, zeroTangent<D>()), arm); };
    for (int k = 0; k < D; ++k)
    {
        const Vector<D> unit = c.frame.col(k);
        c.w.col(k) = c.frame.transpose() * (inverseMasses * unit + velocity(c.turningI, c.armI, unit) +
                                            velocity(c.turningJ, c.armJ, unit));
    }
    c.rollingW = c.turningI.inverse.trace() / (c.turningI.length * c.turningI.length) +
                 c.turningJ.inverse.trace() / (c.turningJ.length * c.turningJ.length);
}

/// Solve for the rolling moment: the projection of moment - rate/W on |moment| <= rollingLength r_n.
/// Returns the square of W times its change, as a velocity at the distance rollingLength [m^2/s^2].
template <int D>
double solveRolling(LeveredContact<D>& c, Body<D>& a, Body<D>& b)
{
    const Tangent<D> moment = limited(Tangent<D>(c.moment - rollingRate(c, a, b) / c.rollingW),
                                      c.rollingLength * c.impulse[0]);
    const Tangent<D> change = moment - c.moment;
    c.moment = moment;
    apply<D>(c, a, b, Vector<D>::Zero(), change);
    const double scale = c.rollingW * c.rollingLength;
    return scale * scale * squaredNorm(change);
}

/// Solve the contact for the present velocities of its bodies and update them.  Returns the square of W times the
/// change of the impulse [m^2/s^2].
template <int D>
double solve(LeveredContact<D>& c, Body<D>* bodies)
{
    Body<D>& a = bodies[c.i];
    Body<D>& b = bodies[c.j];
    Vector<D> q = c.frame.transpose() * relativeVelocity(c, a, b);
    q[0] += c.approachLimit;
    q -= c.w * c.impulse;
    const Vector<D> impulse = solveLocal<D>(c.w, q, c.friction);
    const Vector<D> change = impulse - c.impulse;
    c.impulse = impulse;
    apply<D>(c, a, b, c.frame * change, zeroTangent<D>());
    double largest = (c.w.diagonal().array() * change.array()).matrix().squaredNorm();
    if (c.rollingLength > 0)
    {
        largest = std::max(largest, solveRolling(c, a, b));
    }
    return largest;
}

/// Square of the natural-map residual in velocity units [m^2/s^2].
template <int D>
double residual(const LeveredContact<D>& c, const Body<D>* bodies)
{
    const Body<D>& a = bodies[c.i];
    const Body<D>& b = bodies[c.j];
    Vector<D> u = c.frame.transpose() * relativeVelocity(c, a, b);
    u[0] += c.approachLimit;
    const double wn = c.w(0, 0);
    const double normalDefect = wn * c.impulse[0] - std::max(0.0, wn * c.impulse[0] - u[0]);

    const double wt = (c.w.trace() - wn) / (D - 1);
    const Eigen::Matrix<double, D - 1, 1> scaled = wt * c.impulse.template tail<D - 1>();
    Eigen::Matrix<double, D - 1, 1> projected = scaled - u.template tail<D - 1>();
    const double bound = wt * c.friction * c.impulse[0];
    const double length = projected.norm();
    if (length > bound)
    {
        projected *= bound / length;
    }
    double largest = std::max(normalDefect * normalDefect, (scaled - projected).squaredNorm());
    if (c.rollingLength > 0)
    {
        const Tangent<D> aim = limited(Tangent<D>(c.moment - rollingRate(c, a, b) / c.rollingW),
                                       c.rollingLength * c.impulse[0]);
        const double scale = c.rollingW * c.rollingLength;
        largest = std::max(largest, scale * scale * squaredNorm(Tangent<D>(aim - c.moment)));
    }
    return largest;
}

}  // namespace nscd
