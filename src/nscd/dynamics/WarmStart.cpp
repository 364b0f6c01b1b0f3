// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How much of the forces in its contacts a sub-step leaves to the next one as a start.

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RigidMotion.hpp"

namespace nscd
{

namespace
{

/// Contacts are relieved when they give less than this part of the most that they gave: beyond what comes and goes
/// with the tolerance in a bed at rest, which keeps all.
constexpr double relieved = 0.9;

}  // namespace

template <int D>
double ContactDynamics<D>::Implementation::givenByContacts(double dt) const
{
    const double unknown = settings_.tolerance / dt;
    double momentum = 0;
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const double change = (bodies_[candidates_.place()[i]].velocity - free_.velocity[i]).norm();
        momentum += heaviness_[i] * grains_.mass[i] * (change + unknown);
    }
    std::size_t k = grains_.size();
    for (const WallBody<D>& wall : wallBodies_)
    {
        if (isFree(wall))
        {
            momentum += wall.mass * ((bodies_[k++].velocity - FreeWall<D>(wall, dt).velocity).norm() + unknown);
        }
    }
    return momentum / dt;
}

template <int D>
double ContactDynamics<D>::Implementation::keptPart(double dt)
{
    const double given = givenByContacts(dt);
    const double part = given < relieved * mostGiven_ && unevenness_ <= evenMasses ? given / mostGiven_ : 1;
    mostGiven_ = part < 1 ? given : std::max(mostGiven_, given);
    return part;
}

template double ContactDynamics<2>::Implementation::givenByContacts(double) const;
template double ContactDynamics<3>::Implementation::givenByContacts(double) const;
template double ContactDynamics<2>::Implementation::keptPart(double);
template double ContactDynamics<3>::Implementation::keptPart(double);

}  // namespace nscd
