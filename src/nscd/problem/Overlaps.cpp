// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactProblem's second problem: displacements that remove what would overlap at the end of the step.

#include "nscd/problem/ContactProblem.hpp"

namespace nscd
{

template <int D>
Depths ContactProblem<D>::measureOverlaps(const std::vector<Body<D>>& bodies, double share, double shallow)
{
    Depths depths;
    overlaps_.clear();
    overlapBegin_.clear();
    listed_.assign(kept_.size(), 0);
    const auto add = [&](const auto& c, const Vector<D>& normal, const Origin& origin)
    {
        const double velocity = normalVelocity(c, bodies[c.i], bodies[c.j]) + origin.gap / dt_;
        const double slow = -shallow * arrangement_.radius(candidates_.pairs()[origin.pair]) / dt_;
        const bool spares = velocity < 0 && !hadImpact(c.i) && !hadImpact(c.j);
        const double removed = spares ? velocity - (1 - share) * std::max(velocity, slow) : velocity;
        depths.deep = depths.deep || velocity < slow;
        depths.worst = std::max(depths.worst, -velocity);
        depths.spared = std::max(depths.spared, removed - velocity);
        overlaps_.push_back({normal, removed, 1 / normalW(bodies[c.i], bodies[c.j]), 0, c.i, c.j});
        listed_[origin.pair] = 1;
    };
    for (std::size_t g = 0; g + 1 < begin_.size(); ++g)
    {
        overlapBegin_.push_back(overlaps_.size());
        for (std::size_t k = begin_[g].contact; k < begin_[g + 1].contact; ++k)
        {
            add(contacts_[k], contacts_[k].normal, origin_[k]);
        }
        for (std::size_t k = begin_[g].levered; k < begin_[g + 1].levered; ++k)
        {
            add(levered_[k], levered_[k].normal(), leveredOrigin_[k]);
        }
    }
    overlapBegin_.push_back(overlaps_.size());
    return depths;
}

template <int D>
bool ContactProblem<D>::hadImpact(int body) const
{
    return !data_.ahead.empty() && body < candidates_.fixedBody() && data_.ahead[body].inverseMass > 0;
}

template <int D>
double ContactProblem<D>::separate(int group, std::vector<Body<D>>& displacements)
{
    double largest = 0;
    for (std::size_t k = overlapBegin_[group]; k < overlapBegin_[group + 1]; ++k)
    {
        largest = std::max(largest, nscd::separate<D>(overlaps_[k], displacements.data()));
    }
    return largest;
}

template <int D>
double ContactProblem<D>::separationResidual(const std::vector<Body<D>>& displacements) const
{
    double largest = 0;
    for (const Overlap<D>& o : overlaps_)
    {
        const Body<D>&a = displacements[o.i], &b = displacements[o.j];
        const double velocity = (b.velocity - a.velocity).dot(o.normal) + o.gapVelocity;
        const double push = o.push / o.inverseW;
        largest = std::max(largest, std::abs(push - std::max(0.0, push - velocity)));
    }
    return largest;
}

template <int D>
double ContactProblem<D>::addPushed(const std::vector<Body<D>>& bodies, const std::vector<Body<D>>& displacements)
{
    double largest = 0;
    std::vector<Overlap<D>> pushed;
    std::vector<std::size_t> pushedBegin;
    for (const Group& group : candidates_.groups())
    {
        pushedBegin.push_back(pushed.size());
        for (std::size_t p = group.begin; p < group.end; ++p)
        {
            if (listed_[p])
            {
                continue;
            }
            const Pair& pair = candidates_.pairs()[p];
            const int i = candidates_.body(pair.first), j = candidates_.secondBody(pair);
            const Vector<D> displacement = displacements[j].velocity - displacements[i].velocity;
            const auto opening = displacement.isZero(0) ? std::nullopt : openingOf(p, bodies, displacement);
            if (!opening)
            {
                continue;
            }
            const double velocity = opening->velocity + opening->gap / dt_;
            const double depth = -(velocity + displacement.dot(opening->normal));
            if (depth > 0)
            {
                largest = std::max(largest, depth);
                listed_[p] = 1;
                pushed.push_back({opening->normal, velocity, 1 / normalW(bodies[i], bodies[j]), 0, i, j});
            }
        }
    }
    pushedBegin.push_back(pushed.size());
    if (!pushed.empty())
    {
        insertOverlaps(pushed, pushedBegin);
    }
    return largest;
}

template <int D>
void ContactProblem<D>::insertOverlaps(const std::vector<Overlap<D>>& more, const std::vector<std::size_t>& moreBegin)
{
    std::vector<Overlap<D>> all;
    std::vector<std::size_t> begin;
    for (std::size_t g = 0; g + 1 < overlapBegin_.size(); ++g)
    {
        begin.push_back(all.size());
        all.insert(all.end(), overlaps_.begin() + overlapBegin_[g], overlaps_.begin() + overlapBegin_[g + 1]);
        all.insert(all.end(), more.begin() + moreBegin[g], more.begin() + moreBegin[g + 1]);
    }
    begin.push_back(all.size());
    overlaps_.swap(all);
    overlapBegin_.swap(begin);
}

template Depths ContactProblem<2>::measureOverlaps(const std::vector<Body<2>>&, double, double);
template Depths ContactProblem<3>::measureOverlaps(const std::vector<Body<3>>&, double, double);
template bool ContactProblem<2>::hadImpact(int) const;
template bool ContactProblem<3>::hadImpact(int) const;
template double ContactProblem<2>::separate(int, std::vector<Body<2>>&);
template double ContactProblem<3>::separate(int, std::vector<Body<3>>&);
template double ContactProblem<2>::separationResidual(const std::vector<Body<2>>&) const;
template double ContactProblem<3>::separationResidual(const std::vector<Body<3>>&) const;
template double ContactProblem<2>::addPushed(const std::vector<Body<2>>&, const std::vector<Body<2>>&);
template double ContactProblem<3>::addPushed(const std::vector<Body<3>>&, const std::vector<Body<3>>&);

}  // namespace nscd
