// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/ContactProblem.hpp"

namespace nscd
{

namespace
{

/// Contacts that would stay apart by less than this fraction of the smaller radius are chosen all the same: their
/// velocities change during the sweeps, and what is missed costs another choice.
constexpr double margin = 0.02;

/// An overlap deeper than this fraction of the smaller radius is removed in several steps, so that the grains
/// nearby are noticed in time.
constexpr double largestPush = 0.1;

/// A contact that carried an impulse in the last sub-step may open by this fraction of the smaller radius before its
/// grains may approach again.  Otherwise the gaps that the removal of overlaps opens next to them close under the
/// load, step after step, and a deep pile whose impulses do not converge sinks into itself.
constexpr double slack = 5e-3;

template <int D>
Tangent<D> inTangentPlane(const Tangent<D>& impulse, const Vector<D>& normal)
{
    if constexpr (D == 2)
    {
        return impulse;
    }
    else
    {
        return impulse - impulse.dot(normal) * normal;
    }
}

}  // namespace

template <int D>
void ContactProblem<D>::begin(const std::vector<Impulse<D>>& impulses, double dt)
{
    dt_ = dt;
    incomplete_ = false;
    kept_.assign(impulses.size(), 0);
    loaded_.resize(impulses.size());
    std::transform(impulses.begin(), impulses.end(), loaded_.begin(),
                   [](const Impulse<D>& impulse) { return impulse.normal > 0; });
}

template <int D>
void ContactProblem<D>::choose(const std::vector<Body<D>>& bodies, const std::vector<Impulse<D>>& impulses)
{
    const int wall = static_cast<int>(bodies.size()) - 1;
    contacts_.clear();
    source_.clear();
    gap_.clear();
    begin_.clear();
    for (const Group& group : candidates_.groups())
    {
        begin_.push_back(contacts_.size());
        for (std::size_t p = group.begin; p < group.end; ++p)
        {
            const Pair& pair = candidates_.pairs()[p];
            const auto approach = arrangement_.approach(pair);
            if (!approach)
            {
                continue;
            }
            const int j = pair.second < 0 ? wall : pair.second;
            const double velocity = (bodies[j].velocity - bodies[pair.first].velocity).dot(approach->normal);
            if (approach->gap + dt_ * velocity >= margin * arrangement_.radius(pair) && !kept_[p])
            {
                continue;
            }
            const double open = loaded_[p] ? slack * arrangement_.radius(pair) : 0;
            contacts_.push_back({approach->normal, std::max(0.0, approach->gap - open) / dt_,
                                 1 / (bodies[pair.first].inverseMass + bodies[j].inverseMass),
                                 arrangement_.parameters(pair).friction, impulses[p].normal,
                                 inTangentPlane<D>(impulses[p].tangential, approach->normal), pair.first, j});
            gap_.push_back(std::max(approach->gap, -largestPush * arrangement_.radius(pair)));
            source_.push_back(p);
            kept_[p] = 1;
        }
    }
    begin_.push_back(contacts_.size());
}

template <int D>
void ContactProblem<D>::applyImpulses(int group, std::vector<Body<D>>& bodies) const
{
    for (std::size_t c = begin_[group]; c < begin_[group + 1]; ++c)
    {
        const Contact<D>& contact = contacts_[c];
        apply<D>(contact, bodies[contact.i], bodies[contact.j], contact.normalImpulse, contact.slipImpulse);
    }
}

template <int D>
double ContactProblem<D>::sweep(int group, std::vector<Body<D>>& bodies)
{
    double largest = 0;
    Body<D>* body = bodies.data();
    Contact<D>* end = contacts_.data() + begin_[group + 1];
    for (Contact<D>* contact = contacts_.data() + begin_[group]; contact != end; ++contact)
    {
        largest = std::max(largest, solve<D>(*contact, body));
    }
    return largest;
}

template <int D>
double ContactProblem<D>::residual(const std::vector<Body<D>>& bodies)
{
    const std::size_t wall = bodies.size() - 1;
    double largest = 0;
    double largestSquare = 0;
    incomplete_ = false;
    for (std::size_t g = 0; g < candidates_.groups().size(); ++g)
    {
        const Group& group = candidates_.groups()[g];
        std::size_t contact = begin_[g];
        for (std::size_t p = group.begin; p < group.end; ++p)
        {
            if (contact < begin_[g + 1] && source_[contact] == p)
            {
                largestSquare = std::max(largestSquare, nscd::residual<D>(contacts_[contact], bodies.data()));
                ++contact;
                continue;
            }
            const Pair& pair = candidates_.pairs()[p];
            const auto approach = arrangement_.approach(pair);
            if (!approach)
            {
                continue;
            }
            const std::size_t j = pair.second < 0 ? wall : pair.second;
            const double velocity = (bodies[j].velocity - bodies[pair.first].velocity).dot(approach->normal);
            const double penetration = -(velocity + std::max(0.0, approach->gap) / dt_);
            if (penetration > 0)
            {
                kept_[p] = 1;
                incomplete_ = true;
                largest = std::max(largest, penetration);
            }
        }
    }
    return std::max(largest, std::sqrt(largestSquare));
}

template <int D>
double ContactProblem<D>::measureOverlaps(const std::vector<Body<D>>& bodies, double share)
{
    double worst = 0;
    overlaps_.clear();
    overlaps_.reserve(contacts_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k)
    {
        const Contact<D>& c = contacts_[k];
        const double velocity = (bodies[c.j].velocity - bodies[c.i].velocity).dot(c.normal) + gap_[k] / dt_;
        worst = std::max(worst, -velocity);
        overlaps_.push_back({c.normal, velocity < 0 ? share * velocity : velocity, c.inverseW, 0, c.i, c.j});
    }
    return worst;
}

template <int D>
double ContactProblem<D>::separate(int group, std::vector<Body<D>>& displacements)
{
    double largest = 0;
    for (std::size_t k = begin_[group]; k < begin_[group + 1]; ++k)
    {
        largest = std::max(largest, nscd::separate<D>(overlaps_[k], displacements.data()));
    }
    return largest;
}

template <int D>
void ContactProblem<D>::store(std::vector<Impulse<D>>& impulses) const
{
    std::fill(impulses.begin(), impulses.end(), Impulse<D>());
    for (std::size_t c = 0; c < contacts_.size(); ++c)
    {
        if (contacts_[c].normalImpulse > 0)
        {
            impulses[source_[c]] = {contacts_[c].normalImpulse, contacts_[c].slipImpulse};
        }
    }
}

template <int D>
std::size_t ContactProblem<D>::active() const
{
    return std::count_if(contacts_.begin(), contacts_.end(), [](const Contact<D>& c) { return c.normalImpulse > 0; });
}

template class ContactProblem<2>;
template class ContactProblem<3>;

}  // namespace nscd
