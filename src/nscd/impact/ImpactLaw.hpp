// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/LeveredContact.hpp"

namespace nscd
{

/// Work of an impulse r on two bodies with relative velocity u at the contact, W their local operator [J].
template <int D>
double work(const Block<D>& W, const Vector<D>& u, const Vector<D>& r)
{
    return r.dot(u + 0.5 * (W * r));
}

/// The impulse of one impact [N s]: restitution 0 <= e <= 1 of the normal velocity u_N < 0, friction 0 <= mu;
/// components (N, T ...) as in solveLocal(), W symmetric and positive definite.
///
/// Newton's rule f, which solves Signorini and Coulomb's problem for u + e u_N n, may create energy where W couples the
/// normal with the tangent (Stronge 1990, doi:10.1098/rspa.1990.0125).  The plastic impulse p, e = 0, never does. Hence
///
///     r = p + theta (f - p),  theta the largest in [0, 1] with  E(r) <= (1 - e^2) E(p),   E(r) = r.u + r.Wr/2.
///
/// It exists because E(p) <= 0 and E is convex; Coulomb's law holds as its cone is convex, too.  Central impacts have
/// theta = 1, and the loss of energy (1 - e^2) of the plastic one without friction (doc/theory, eq. 5.15).
template <int D>
Vector<D> impactImpulse(const Block<D>& W, const Vector<D>& u, double mu, double e)
{
    const Vector<D> plastic = solveLocal<D>(W, u, mu);
    Vector<D> reflected = u;
    reflected[0] += e * u[0];
    const Vector<D> step = solveLocal<D>(W, reflected, mu) - plastic;

    // E(p + theta step) - (1 - e^2) E(p) = a + b theta + c theta^2
    const double a = e * e * std::min(0.0, work<D>(W, u, plastic));
    const double b = step.dot(u + W * plastic);
    const double c = 0.5 * step.dot(W * step);
    if (a + b + c <= 0 || c <= 0)
    {
        return plastic + step;
    }
    const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
    const double theta = b > 0 ? -2 * a / (b + root) : (root - b) / (2 * c);
    return plastic + std::min(1.0, theta) * step;
}

/// Resistance to rolling in an impact whose normal impulse has been given, and stays: the moment and friction in turn
/// come to where they end rolling and slip, within their bounds (doc/theory, eq. 5.24).  The relative velocity is that
/// of the bodies and 'more' [m/s].  No pass gives energy to the bodies, so that none need be the last.
template <int D>
void resistRolling(LeveredContact<D>& c, Body<D>& a, Body<D>& b, const Vector<D>& more)
{
    constexpr int mostPasses = 100;
    constexpr double accuracy = 1e-10;   // of the change of the normal velocity
    const auto largest = [](const auto& matrix) { return matrix.cwiseAbs().rowwise().sum().maxCoeff(); };
    c.rollingW = largest(c.turningI.inverse / (c.turningI.length * c.turningI.length) +
                         c.turningJ.inverse / (c.turningJ.length * c.turningJ.length));
    const double slipW = largest(c.w.template bottomRightCorner<D - 1, D - 1>());
    const double bound = c.friction * c.impulse[0];
    const double small = accuracy * c.w(0, 0) * c.impulse[0];
    double change = small * small;
    for (int pass = 0; pass < mostPasses && small > 0 && change >= small * small; ++pass)
    {
        change = solveRolling(c, a, b);
        const Vector<D> slip = c.frame.transpose() * Vector<D>(relativeVelocity(c, a, b) + more);
        Vector<D> impulse = c.impulse;
        impulse.template tail<D - 1>() -= slip.template tail<D - 1>() / slipW;
        const double length = impulse.template tail<D - 1>().norm();
        if (length > bound)
        {
            impulse.template tail<D - 1>() *= bound / length;
        }
        const Vector<D> step = impulse - c.impulse;
        apply<D>(c, a, b, c.frame * step, zeroTangent<D>());
        c.impulse = impulse;
        change = std::max(change, slipW * slipW * step.squaredNorm());
    }
}

/// The impulse of impactImpulse() for a contact with its normal through both centres: W is diagonal (doc/theory,
/// eq. 5.13).
template <int D>
Contact<D> centralImpact(const Vector<D>& normal, const Vector<D>& relative, const Body<D>& a, const Body<D>& b,
                         double mu, double e)
{
    Contact<D> c{};
    c.normal = normal;
    c.inverseW = 1 / normalW(a, b);
    c.normalImpulse = std::max(0.0, -(1 + e) * relative.dot(normal) * c.inverseW);
    c.slipImpulse = limited(Tangent<D>(slip(c, a, b, relative) * (-1 / tangentW(a, b))), mu * c.normalImpulse);
    return c;
}

}  // namespace nscd
