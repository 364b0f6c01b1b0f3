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
void ContactDynamics<D>::Implementation::keepTouching(double dt)
{
    if (!recordsTouching_)
    {
        return;
    }
    const auto grainOf = [&](int place)
    { return place < 0 ? place : members_.grain(candidates_.memberOrder()[place]); };
    std::vector<Touching<D>> lasting, brief;
    for (const ContactForce<D>& c : problem_.forces({}))
    {
        lasting.push_back({grainOf(c.first), grainOf(c.second), c.point, c.pressing * dt, dt, 0});
    }
    for (const PairImpulse<D>& impact : impacts_.impulses())
    {
        const Pair& pair = candidates_.pairs()[impact.pair];
        const Vector<D> point = arrangement_.contactPoint(pair, {impact.normal, impact.gap});
        brief.push_back({grainOf(pair.first), grainOf(pair.second), point, impact.pressing, 0, impact.impacts});
    }
    touching_.push_back(std::move(lasting));
    touching_.push_back(std::move(brief));
}

template <int D>
std::vector<Touching<D>> ContactDynamics<D>::Implementation::touching() const
{
    std::vector<Touching<D>> all;
    for (const std::vector<Touching<D>>& mine : touching_)
    {
        const std::vector<Touching<D>> gathered = communicator_.gather(mine);
        all.insert(all.end(), gathered.begin(), gathered.end());
    }
    return all;
}

template void ContactDynamics<2>::Implementation::recordTouching(bool);
template void ContactDynamics<3>::Implementation::recordTouching(bool);
template void ContactDynamics<2>::Implementation::keepTouching(double);
template void ContactDynamics<3>::Implementation::keepTouching(double);
template std::vector<Touching<2>> ContactDynamics<2>::Implementation::touching() const;
template std::vector<Touching<3>> ContactDynamics<3>::Implementation::touching() const;

}  // namespace nscd
