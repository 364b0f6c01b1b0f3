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

/// The same for a contact with its normal through both centres: W is diagonal (doc/theory, eq. 5.13).
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
