// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Contact.hpp"

namespace nscd
{

/// A body that flies from impact to impact within a sub-step: from the last one on it is where it would be at the time
/// t if it had started at the offset from its place at the beginning, with the present velocity (doc/theory, eq. 5.12).
template <int D>
struct alignas(64) Flyer
{
    // What predictions read comes first, in one line of the cache
    double clock = 0;                           ///< time of the last impact [s]
    int impacts = 0;
    Vector<D> offset = Vector<D>::Zero();       ///< [m]
    Body<D> body;
    Tangent<D> turned = zeroTangent<D>();       ///< the offset of the way of its surface [m]
    double farthest = 0;                        ///< from the place where candidates were listed, at impacts [m]

    // Of what is not round: its orientation, and the time at which it has this one and its body's spin [s]
    double since = 0;
    Orientation<D> orientation = Orientation<D>::Identity();
};

/// What acts on a body in a sub-step, and where it is.
template <int D>
struct Launch
{
    Vector<D> push = Vector<D>::Zero();   ///< change of velocity by forces [m/s]
    Vector<D> drift = Vector<D>::Zero();  ///< way since candidates were listed [m]
    double turned = 0;                    ///< the same of the surface of what is not round [m]
    bool round = true;
    double viscosity = 0;                 ///< of the fluid around it; 0 for none [Pa s]
};

/// How far a flyer that has had this velocity since its last impact is at the time t [s] from where candidates were
/// listed: the farthest of its points [m].
template <int D>
double way(const Flyer<D>& flyer, const Body<D>& body, const Launch<D>& launch, double t)
{
    const double centre = (launch.drift + flyer.offset + t * body.velocity).norm();
    if (launch.round)
    {
        return centre;
    }
    const Tangent<D> turned = flyer.turned + t * body.surfaceSpeed;
    return centre + launch.turned + std::sqrt(squaredNorm(turned));
}

}  // namespace nscd
