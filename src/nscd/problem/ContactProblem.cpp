// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The sweeps over a chosen set of contacts.

#include "nscd/problem/ContactProblem.hpp"

namespace nscd
{

template <int D>
void ContactProblem<D>::applyImpulses(int group, std::vector<Body<D>>& bodies) const
{
    for (std::size_t k = begin_[group].contact; k < begin_[group + 1].contact; ++k)
    {
        const Contact<D>& c = contacts_[k];
        apply<D>(c, bodies[c.i], bodies[c.j], c.normalImpulse - origin_[k].attraction, c.slipImpulse);
    }
    for (std::size_t k = begin_[group].levered; k < begin_[group + 1].levered; ++k)
    {
        const LeveredContact<D>& c = levered_[k];
        apply<D>(c, bodies[c.i], bodies[c.j], c.frame * c.impulse - leveredOrigin_[k].attraction * c.normal(),
                 c.moment);
    }
}

template <int D>
Change ContactProblem<D>::sweep(int group, std::vector<Body<D>>& bodies)
{
    Change change;
    Body<D>* body = bodies.data();
    Contact<D>* end = contacts_.data() + begin_[group + 1].contact;
    for (Contact<D>* contact = contacts_.data() + begin_[group].contact; contact != end; ++contact)
    {
        change.add(solve<D>(*contact, body));
    }
    for (std::size_t k = begin_[group].levered; k < begin_[group + 1].levered; ++k)
    {
        change.add(solve<D>(levered_[k], body));
    }
    return change;
}

template <int D>
double ContactProblem<D>::residual(const std::vector<Body<D>>& bodies)
{
    double largest = 0;
    for (const Contact<D>& contact : contacts_)
    {
        largest = std::max(largest, nscd::residual<D>(contact, bodies.data()));
    }
    for (const LeveredContact<D>& contact : levered_)
    {
        largest = std::max(largest, nscd::residual<D>(contact, bodies.data()));
    }
    return std::max(std::sqrt(largest), findMissing(bodies));
}

template <int D>
bool ContactProblem<D>::isCut() const
{
    const auto cut = [](const Origin& o) { return o.gap > o.wholeGap; };
    return std::any_of(origin_.begin(), origin_.end(), cut) ||
           std::any_of(leveredOrigin_.begin(), leveredOrigin_.end(), cut);
}

template <int D>
std::vector<PassedWall> ContactProblem<D>::passedWalls(const std::vector<Body<D>>& bodies,
                                                       const std::vector<Body<D>>& displacements) const
{
    std::vector<PassedWall> passed;
    const auto check = [&](const auto& c, const Vector<D>& normal, const Origin& origin)
    {
        const Pair& pair = candidates_.pairs()[origin.pair];
        if (pair.second >= 0)
        {
            return;
        }
        double velocity = normalVelocity(c, bodies[c.i], bodies[c.j]);
        if (!displacements.empty())
        {
            velocity += (displacements[c.j].velocity - displacements[c.i].velocity).dot(normal);
        }
        const double height = origin.wholeGap + arrangement_.radius(pair);
        if (height > 0 && height + dt_ * velocity <= 0)
        {
            passed.push_back({pair.first, ~pair.second, origin.wholeGap});
        }
    };
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        check(contacts_[k], contacts_[k].normal, origin_[k]);
    }
    for (std::size_t k = 0; k < levered_.size(); ++k)
    {
        check(levered_[k], levered_[k].normal(), leveredOrigin_[k]);
    }
    return passed;
}

template <int D>
void ContactProblem<D>::store(std::vector<Impulse<D>>& impulses) const
{
    for (Impulse<D>& impulse : impulses)
    {
        if (impulse.normal > 0)
        {
            impulse = {0, zeroTangent<D>(), zeroTangent<D>(), impulse.age};
        }
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        const Contact<D>& c = contacts_[k];
        if (c.normalImpulse > 0)
        {
            Impulse<D>& impulse = impulses[origin_[k].pair];
            impulse.normal = c.normalImpulse;
            impulse.tangential = c.slipImpulse;
            impulse.attraction = origin_[k].attraction;
        }
    }
    for (std::size_t k = 0; k < levered_.size(); ++k)
    {
        const LeveredContact<D>& c = levered_[k];
        if (c.impulse[0] > 0)
        {
            Impulse<D>& impulse = impulses[leveredOrigin_[k].pair];
            impulse.normal = c.impulse[0];
            impulse.tangential = tangential(c);
            impulse.rolling = c.moment;
            impulse.attraction = leveredOrigin_[k].attraction;
        }
    }
}

template <int D>
template <class Wanted, class F>
void ContactProblem<D>::forImpulses(std::size_t group, Wanted&& wanted, F&& f) const
{
    // One that attracts and presses no more parts in this step, and has pulled in it
    for (std::size_t k = begin_[group].contact; k < begin_[group + 1].contact; ++k)
    {
        const Contact<D>& c = contacts_[k];
        const Origin& origin = origin_[k];
        if ((c.normalImpulse > 0 || origin.attraction > 0) && wanted(origin.pair))
        {
            f(PairImpulse<D>{origin.pair, c.normal, origin.gap,
                             impulseVector(c.normal, c.normalImpulse - origin.attraction, c.slipImpulse),
                             c.normalImpulse, 0, zeroTangent<D>()});
        }
    }
    for (std::size_t k = begin_[group].levered; k < begin_[group + 1].levered; ++k)
    {
        const LeveredContact<D>& c = levered_[k];
        const Origin& origin = leveredOrigin_[k];
        if ((c.impulse[0] > 0 || origin.attraction > 0) && wanted(origin.pair))
        {
            f(PairImpulse<D>{origin.pair, c.normal(), origin.gap,
                             c.frame * c.impulse - origin.attraction * c.normal(), c.impulse[0], 0, c.moment});
        }
    }
}

template <int D>
std::vector<ContactForce<D>> ContactProblem<D>::forces(const std::vector<PairImpulse<D>>& impacts) const
{
    std::vector<ContactForce<D>> result;
    auto impact = impacts.begin();
    std::vector<int> placeOf(impacts.empty() ? 0 : candidates_.pairs().size(), -1);
    const auto add = [&](const PairImpulse<D>& c)
    {
        const Pair& pair = candidates_.pairs()[c.pair];
        if (!placeOf.empty())
        {
            placeOf[c.pair] = static_cast<int>(result.size());
        }
        result.push_back({pair.first, pair.second, arrangement_.contactPoint(pair, {c.normal, c.gap}), c.normal,
                          c.impulse / dt_, c.gap, c.pressing / dt_, toSpin(c.moment) / dt_});
    };
    for (std::size_t g = 0; g + 1 < begin_.size(); ++g)
    {
        forImpulses(g, [](std::size_t) { return true; }, add);
        for (; impact != impacts.end() && impact->pair < candidates_.groups()[g].end; ++impact)
        {
            if (placeOf[impact->pair] < 0)
            {
                add(*impact);
                continue;
            }
            ContactForce<D>& force = result[placeOf[impact->pair]];
            force.force += impact->impulse / dt_;
            force.moment += toSpin(impact->moment) / dt_;
            force.pressing += impact->pressing / dt_;
        }
    }
    return result;
}

template <int D>
std::vector<WallImpulse<D>> ContactProblem<D>::wallImpulses(const std::vector<PairImpulse<D>>& impacts) const
{
    std::vector<WallImpulse<D>> result;
    auto impact = impacts.begin();
    const auto isOfWall = [&](std::size_t pair) { return candidates_.pairs()[pair].second < 0; };
    const auto add = [&](const PairImpulse<D>& c)
    {
        const Pair& pair = candidates_.pairs()[c.pair];
        const Vector<D> point = arrangement_.contactPoint(pair, {c.normal, c.gap});
        result.push_back({~pair.second, point, c.impulse, toSpin(c.moment)});
    };
    for (std::size_t g = 0; g + 1 < begin_.size(); ++g)
    {
        forImpulses(g, isOfWall, add);
        for (; impact != impacts.end() && impact->pair < candidates_.groups()[g].end; ++impact)
        {
            if (isOfWall(impact->pair))
            {
                add(*impact);
            }
        }
    }
    return result;
}

template <int D>
std::size_t ContactProblem<D>::active() const
{
    return std::count_if(contacts_.begin(), contacts_.end(), [](const Contact<D>& c) { return c.normalImpulse > 0; }) +
           std::count_if(levered_.begin(), levered_.end(), [](const LeveredContact<D>& c) { return c.impulse[0] > 0; });
}

template class ContactProblem<2>;
template class ContactProblem<3>;

}  // namespace nscd
