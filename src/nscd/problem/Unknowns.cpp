// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactProblem's unknowns as one list of numbers: impulses, then the velocities that are linear in them.

#include "nscd/problem/ContactProblem.hpp"

namespace nscd
{

namespace
{

template <class F>
void forNumbers(double& value, F&& f)
{
    f(value);
}

template <class V, class F>
void forNumbers(V& values, F&& f)
{
    for (auto& value : values) f(value);
}

/// f(number, weight) for the unknowns of a contact; the weight makes it a velocity.
template <int D, class F>
void forUnknowns(Contact<D>& c, const std::vector<Body<D>>& bodies, F&& f)
{
    const Body<D>&a = bodies[c.i], &b = bodies[c.j];
    f(c.normalImpulse, normalW(a, b));
    forNumbers(c.slipImpulse, [&](double& x) { f(x, tangentW(a, b)); });
}

template <int D, class F>
void forUnknowns(LeveredContact<D>& c, F&& f)
{
    int k = 0;
    forNumbers(c.impulse,
               [&](double& x)
               {
                   f(x, c.w(k, k));
                   ++k;
               });
    forNumbers(c.moment, [&](double& x) { f(x, c.rollingW * c.rollingLength); });
}

template <int D, class F>
void forUnknowns(Overlap<D>& o, F&& f)
{
    f(o.push, 1 / o.inverseW);
}

template <int D, class F>
void forVelocities(std::vector<Body<D>>& bodies, std::size_t begin, std::size_t end, F&& f)
{
    for (std::size_t b = begin; b < end; ++b)
    {
        forNumbers(bodies[b].velocity, f);
        forNumbers(bodies[b].surfaceSpeed, f);
    }
}

}  // namespace

template <int D>
template <class F>
void ContactProblem<D>::forGroups(const std::vector<Body<D>>& bodies, bool overlaps, F&& f)
{
    for (std::size_t g = 0; g + 1 < begin_.size(); ++g)
    {
        const Begin &from = begin_[g], &to = begin_[g + 1];
        for (std::size_t k = from.contact; !overlaps && k < to.contact; ++k)
        {
            forUnknowns<D>(contacts_[k], bodies, [&](double& x, double w) { f(g, x, w); });
        }
        for (std::size_t k = from.levered; !overlaps && k < to.levered; ++k)
        {
            forUnknowns<D>(levered_[k], [&](double& x, double w) { f(g, x, w); });
        }
        for (std::size_t k = overlaps ? overlapBegin_[g] : 0; overlaps && k < overlapBegin_[g + 1]; ++k)
        {
            forUnknowns<D>(overlaps_[k], [&](double& x, double w) { f(g, x, w); });
        }
    }
}

template <int D>
void ContactProblem<D>::get(Unknowns& u, std::vector<Body<D>>& bodies, bool overlaps, std::size_t begin,
                            std::size_t end)
{
    u.values.clear();
    u.weights.clear();
    u.ranges.clear();
    forGroups(bodies, overlaps,
              [&](std::size_t group, double& x, double weight)
              {
                  const int block = candidates_.groups()[group].first;
                  if (u.ranges.empty() || u.ranges.back().block != block)
                  {
                      u.ranges.push_back({block, u.values.size(), u.values.size()});
                  }
                  u.values.push_back(x);
                  u.weights.push_back(weight);
                  u.ranges.back().end = u.values.size();
              });
    forVelocities<D>(bodies, begin, end, [&](double& x) { u.values.push_back(x); });
}

template <int D>
void ContactProblem<D>::set(const Unknowns& u, std::vector<Body<D>>& bodies, bool overlaps, std::size_t begin,
                            std::size_t end)
{
    auto value = u.values.begin();
    forGroups(bodies, overlaps, [&](std::size_t, double& x, double) { x = *value++; });
    forVelocities<D>(bodies, begin, end, [&](double& x) { x = *value++; });
}

template void ContactProblem<2>::get(Unknowns&, std::vector<Body<2>>&, bool, std::size_t, std::size_t);
template void ContactProblem<3>::get(Unknowns&, std::vector<Body<3>>&, bool, std::size_t, std::size_t);
template void ContactProblem<2>::set(const Unknowns&, std::vector<Body<2>>&, bool, std::size_t, std::size_t);
template void ContactProblem<3>::set(const Unknowns&, std::vector<Body<3>>&, bool, std::size_t, std::size_t);

}  // namespace nscd
