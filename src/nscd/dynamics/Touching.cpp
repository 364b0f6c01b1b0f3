// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which grains and walls touched in the sub-steps of a step.

#include "nscd/dynamics/Implementation.hpp"

namespace nscd
{

template <int D>
void ContactDynamics<D>::Implementation::recordTouching(bool on)
{
    recordsTouching_ = on;
}

template <int D>
std::vector<Touching<D>> ContactDynamics<D>::Implementation::ownTouching(double dt) const
{
    std::vector<Touching<D>> result;
    const auto grainOf = [&](int place)
    { return place < 0 ? place : members_.grain(candidates_.memberOrder()[place]); };
    for (const ContactForce<D>& c : problem_.forces({}))
    {
        result.push_back({grainOf(c.first), grainOf(c.second), c.point, c.pressing * dt, dt, 0});
    }
    for (const PairImpulse<D>& impact : impacts_.impulses())
    {
        const Pair& pair = candidates_.pairs()[impact.pair];
        result.push_back({grainOf(pair.first), grainOf(pair.second),
                          arrangement_.contactPoint(pair, {impact.normal, impact.gap}), impact.pressing, 0,
                          impact.impacts});
    }
    return result;
}

template <int D>
std::vector<Touching<D>> ContactDynamics<D>::Implementation::touching() const
{
    std::vector<Touching<D>> all;
    for (const std::vector<Touching<D>>& ofSubStep : touching_)
    {
        const std::vector<Touching<D>> gathered = communicator_.gather(ofSubStep);
        all.insert(all.end(), gathered.begin(), gathered.end());
    }
    return all;
}

template void ContactDynamics<2>::Implementation::recordTouching(bool);
template void ContactDynamics<3>::Implementation::recordTouching(bool);
template std::vector<Touching<2>> ContactDynamics<2>::Implementation::ownTouching(double) const;
template std::vector<Touching<3>> ContactDynamics<3>::Implementation::ownTouching(double) const;
template std::vector<Touching<2>> ContactDynamics<2>::Implementation::touching() const;
template std::vector<Touching<3>> ContactDynamics<3>::Implementation::touching() const;

}  // namespace nscd
