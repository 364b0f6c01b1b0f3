// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace nscd
{

/// What lives in the tangent plane of a contact: one component along (-n_y, n_x) in 2-D, a vector in 3-D.
template <int D>
struct TangentOf
{
    using type = Vector<3>;
};

template <>
struct TangentOf<2>
{
    using type = double;
};

template <int D>
using Tangent = typename TangentOf<D>::type;

template <int D>
Tangent<D> zeroTangent()
{
    if constexpr (D == 2)
    {
        return 0;
    }
    else
    {
        return Vector<3>::Zero();
    }
}

/// What the sweeps need of a grain; fixed walls are one more body with infinite mass.
template <int D>
struct Body
{
    Vector<D> velocity;
    Tangent<D> surfaceSpeed;   ///< radius times spin [m/s]
    double inverseMass;
    double inverseInertia;     ///< of what is round: square of the radius over the moment of inertia [1/kg]
};

/// A contact with unit normal n from body i to body j; body j receives the impulse r_n n + r_t, body i its opposite.
///
/// With the normal through both centres the local Delassus operator is diagonal,
///     W_NN = 1/m_i + 1/m_j,   W_TT = W_NN + (r^2/I)_i + (r^2/I)_j,
/// so that the local Signorini-Coulomb problem has the closed solution of solve() (doc/theory, eq. 5.3 and 5.4).
template <int D>
struct Contact
{
    Vector<D> normal;
    double approachLimit;      ///< max(gap, 0)/dt [m/s]
    double inverseW;           ///< 1/W_NN [kg]
    double friction;
    double normalImpulse;      ///< r_n [N s]
    Tangent<D> slipImpulse;    ///< r_t [N s]
    int i, j;
};

/// W_NN and W_TT of the local Delassus operator [1/kg].
template <int D>
inline double normalW(const Body<D>& a, const Body<D>& b)
{
    return a.inverseMass + b.inverseMass;
}

template <int D>
inline double tangentW(const Body<D>& a, const Body<D>& b)
{
    return a.inverseMass + b.inverseMass + (a.inverseInertia + b.inverseInertia);
}

/// Tangential part of the relative velocity at the contact point, j against i.
inline double slip(const Contact<2>& c, const Body<2>& a, const Body<2>& b, const Vector<2>& relative)
{
    return c.normal.x() * relative.y() - c.normal.y() * relative.x() - (a.surfaceSpeed + b.surfaceSpeed);
}

inline Vector<3> slip(const Contact<3>& c, const Body<3>& a, const Body<3>& b, const Vector<3>& relative)
{
    return relative - relative.dot(c.normal) * c.normal - (a.surfaceSpeed + b.surfaceSpeed).cross(c.normal);
}

inline Vector<2> impulseVector(const Vector<2>& n, double normal, double tangential)
{
    return {normal * n.x() - tangential * n.y(), normal * n.y() + tangential * n.x()};
}

inline Vector<3> impulseVector(const Vector<3>& n, double normal, const Vector<3>& tangential)
{
    return normal * n + tangential;
}

/// Torque of a tangential impulse over minus the radius; the same for both bodies.
inline double turn(const Vector<2>&, double tangential)
{
    return tangential;
}

inline Vector<3> turn(const Vector<3>& n, const Vector<3>& tangential)
{
    return n.cross(tangential);
}

/// Nearest point of the disc |r_t| <= bound.
inline double limited(double tangential, double bound)
{
    return std::min(bound, std::max(-bound, tangential));
}

inline Vector<3> limited(const Vector<3>& tangential, double bound)
{
    const double square = tangential.squaredNorm();
    return square > bound * bound ? Vector<3>(tangential * (bound / std::sqrt(square))) : tangential;
}

inline double squaredNorm(double t) { return t * t; }
inline double squaredNorm(const Vector<3>& t) { return t.squaredNorm(); }

inline double product(double a, double b) { return a * b; }
inline double product(const Vector<3>& a, const Vector<3>& b) { return a.dot(b); }

/// Give the two bodies an impulse.
template <int D>
inline void apply(const Contact<D>& c, Body<D>& a, Body<D>& b, double normal, const Tangent<D>& tangential)
{
    const Vector<D> impulse = impulseVector(c.normal, normal, tangential);
    const Tangent<D> spinning = turn(c.normal, tangential);
    a.velocity -= a.inverseMass * impulse;
    b.velocity += b.inverseMass * impulse;
    a.surfaceSpeed -= a.inverseInertia * spinning;
    b.surfaceSpeed -= b.inverseInertia * spinning;
}

/// Solve the contact for the present velocities of its bodies and update them:
///     r_n <- [r_n - (u_n + g/dt)/W_NN]+,   r_t <- projection of r_t - u_t/W_TT on |r_t| <= mu r_n.
/// Returns the square of W times the change of the impulse [m^2/s^2].
template <int D>
[[gnu::always_inline]] inline double solve(Contact<D>& c, Body<D>* bodies)
{
    Body<D>& a = bodies[c.i];
    Body<D>& b = bodies[c.j];
    const Vector<D> relative = b.velocity - a.velocity;
    const double tangent = tangentW(a, b);
    const double normal =
        std::max(0.0, c.normalImpulse - (relative.dot(c.normal) + c.approachLimit) * c.inverseW);
    const Tangent<D> tangential =
        limited(c.slipImpulse - slip(c, a, b, relative) * (1 / tangent), c.friction * normal);

    const double normalChange = normal - c.normalImpulse;
    const Tangent<D> tangentialChange = tangential - c.slipImpulse;
    c.normalImpulse = normal;
    c.slipImpulse = tangential;
    apply<D>(c, a, b, normalChange, tangentialChange);

    const double w = normalW(a, b);
    return std::max(w * w * normalChange * normalChange, tangent * tangent * squaredNorm(tangentialChange));
}

/// An overlap to be removed by moving the two bodies apart along the normal, without a change of velocity.
template <int D>
struct Overlap
{
    Vector<D> normal;
    double gapVelocity;   ///< gap at the end of the step over dt [m/s]
    double inverseW;      ///< [kg]
    double push;          ///< >= 0 [N s]
    int i, j;
};

/// The frictionless problem push >= 0, w_n + gapVelocity >= 0, complementary, for displacement velocities w that
/// stand in the bodies' velocity (doc/theory, eq. 5.9).  Returns the square of W times the change of push [m^2/s^2].
template <int D>
inline double separate(Overlap<D>& o, Body<D>* bodies)
{
    Body<D>& a = bodies[o.i];
    Body<D>& b = bodies[o.j];
    const double normalVelocity = (b.velocity - a.velocity).dot(o.normal) + o.gapVelocity;
    const double push = std::max(0.0, o.push - normalVelocity * o.inverseW);
    const double change = push - o.push;
    o.push = push;
    a.velocity -= (change * a.inverseMass) * o.normal;
    b.velocity += (change * b.inverseMass) * o.normal;
    const double w = normalW(a, b);
    return w * w * change * change;
}

/// Velocity with which the contact opens [m/s].
template <int D>
inline double normalVelocity(const Contact<D>& c, const Body<D>& a, const Body<D>& b)
{
    return (b.velocity - a.velocity).dot(c.normal);
}

/// Square of the natural-map residual in velocity units [m^2/s^2]: how far the impulse is from the solution of
/// solve() at the present velocities.
template <int D>
inline double residual(const Contact<D>& c, const Body<D>* bodies)
{
    const Body<D>& a = bodies[c.i];
    const Body<D>& b = bodies[c.j];
    const double w = normalW(a, b), tangent = tangentW(a, b);
    const Vector<D> relative = b.velocity - a.velocity;
    const double normalVelocity = relative.dot(c.normal) + c.approachLimit;
    const Tangent<D> slipVelocity = slip(c, a, b, relative);

    const double normalDefect = w * c.normalImpulse - std::max(0.0, w * c.normalImpulse - normalVelocity);
    const Tangent<D> scaled = tangent * c.slipImpulse;
    const Tangent<D> slipDefect =
        scaled - limited(Tangent<D>(scaled - slipVelocity), tangent * c.friction * c.normalImpulse);
    return std::max(normalDefect * normalDefect, squaredNorm(slipDefect));
}

}  // namespace nscd
