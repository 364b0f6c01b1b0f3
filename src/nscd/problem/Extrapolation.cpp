// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactProblem::extrapolate: the momentum step of accelerated sweeps.  Velocities are linear in the impulses, so that
// both are continued alike.

#include "nscd/problem/ContactProblem.hpp"

namespace nscd
{

namespace
{

template <class T>
void proceed(T& now, T& old, double factor)
{
    const T present = now;
    now += factor * (present - old);
    old = present;
}

}  // namespace

template <int D>
void ContactProblem<D>::remember(const std::vector<Body<D>>& bodies)
{
    oldContacts_ = contacts_;
    oldLevered_ = levered_;
    oldBodies_ = bodies;
}

template <int D>
void ContactProblem<D>::extrapolate(double factor, std::vector<Body<D>>& bodies, std::size_t begin, std::size_t end)
{
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        proceed(contacts_[k].normalImpulse, oldContacts_[k].normalImpulse, factor);
        proceed(contacts_[k].slipImpulse, oldContacts_[k].slipImpulse, factor);
    }
    for (std::size_t k = 0; k < levered_.size(); ++k)
    {
        proceed(levered_[k].impulse, oldLevered_[k].impulse, factor);
        proceed(levered_[k].moment, oldLevered_[k].moment, factor);
    }
    for (std::size_t b = begin; b < end; ++b)
    {
        proceed(bodies[b].velocity, oldBodies_[b].velocity, factor);
        proceed(bodies[b].surfaceSpeed, oldBodies_[b].surfaceSpeed, factor);
    }
}

template void ContactProblem<2>::remember(const std::vector<Body<2>>&);
template void ContactProblem<3>::remember(const std::vector<Body<3>>&);
template void ContactProblem<2>::extrapolate(double, std::vector<Body<2>>&, std::size_t, std::size_t);
template void ContactProblem<3>::extrapolate(double, std::vector<Body<3>>&, std::size_t, std::size_t);

}  // namespace nscd
