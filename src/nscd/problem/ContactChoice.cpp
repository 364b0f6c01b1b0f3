// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which candidates become contacts of a sub-step, and with what data.

#include "nscd/problem/ContactProblem.hpp"

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
/// load, step after step, and a deep pile whose impulses do not converge sinks into itself (doc/theory, eq. 5.8).
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
void ContactProblem<D>::clear()
{
    contacts_.clear();
    levered_.clear();
    origin_.clear();
    leveredOrigin_.clear();
    begin_.clear();
    touchingBegin_.clear();
}

template <int D>
void ContactProblem<D>::begin(const std::vector<Impulse<D>>& impulses, double dt)
{
    dt_ = dt;
    incomplete_ = false;
    loaded_.resize(impulses.size());
    std::transform(impulses.begin(), impulses.end(), loaded_.begin(),
                   [](const Impulse<D>& impulse) { return impulse.normal > 0; });
    kept_ = loaded_;
}

template <int D>
void ContactProblem<D>::choose(std::vector<Body<D>>& bodies, const std::vector<Impulse<D>>& impulses)
{
    bodies.resize(candidates_.fixedBody() + 1);
    clear();
    for (const Group& group : candidates_.groups())
    {
        begin_.push_back({contacts_.size(), levered_.size()});
        for (std::size_t p = group.begin; p < group.end; ++p)
        {
            const Pair& pair = candidates_.pairs()[p];
            const double radius = arrangement_.radius(pair);
            if (!kept_[p] && staysApart(pair, margin * radius, bodies))
            {
                continue;
            }
            const auto approach = arrangement_.approach(pair);
            if (!approach)
            {
                continue;
            }
            const int i = candidates_.body(pair.first);
            if (approach->gap + dt_ * openingVelocity(pair, *approach, bodies) >= margin * radius && !kept_[p])
            {
                continue;
            }
            kept_[p] = 1;
            const int j = secondBody(pair, *approach, bodies);
            const Origin origin{p, std::max(approach->gap, -largestPush * radius),
                                attraction(p, approach->gap, impulses[p])};
            if (isLevered(pair))
            {
                addLevered(pair, *approach, impulses[p], j, bodies);
                LeveredContact<D>& contact = levered_.back();
                contact.approachLimit = approachLimit(p, approach->gap, contact, bodies);
                leveredOrigin_.push_back(origin);
                continue;
            }
            contacts_.push_back({approach->normal, 0, 1 / (bodies[i].inverseMass + bodies[j].inverseMass),
                                 arrangement_.parameters(pair).friction, impulses[p].normal,
                                 inTangentPlane<D>(impulses[p].tangential, approach->normal), i, j});
            contacts_.back().approachLimit = approachLimit(p, approach->gap, contacts_.back(), bodies);
            origin_.push_back(origin);
        }
    }
    begin_.push_back({contacts_.size(), levered_.size()});
}

template <int D>
int ContactProblem<D>::secondBody(const Pair& pair, const Approach<D>& approach, std::vector<Body<D>>& bodies) const
{
    const int body = candidates_.secondBody(pair);
    const int wallBody = pair.second < 0 ? arrangement_.wallBody(~pair.second) : -1;
    if (wallBody < 0 || body != candidates_.fixedBody())
    {
        return body;
    }
    const WallBody<D>& wall = wallBodies_[wallBody];
    const Vector<D> arm = arrangement_.contactPoint(pair, approach) - wall.position;
    // The velocity is that at the contact: only resistance to rolling asks for the spin besides
    bodies.push_back({wallVelocity(wallBody, arm), isLevered(pair) ? toTangent(wall.spin) : zeroTangent<D>(), 0});
    return static_cast<int>(bodies.size()) - 1;
}

template <int D>
bool ContactProblem<D>::staysApart(const Pair& pair, double apart, const std::vector<Body<D>>& bodies) const
{
    return pair.second >= 0 && !arrangement_.hasClusters() &&
           arrangement_.staysApart(pair, apart,
                                   dt_ * (bodies[pair.second].velocity - bodies[pair.first].velocity));
}

template <int D>
bool ContactProblem<D>::isLevered(const Pair& pair) const
{
    return !data_.turning.empty() &&
           (arrangement_.isOfCluster(pair) || arrangement_.parameters(pair).rolling > 0 ||
            (pair.second < 0 && candidates_.secondBody(pair) != candidates_.fixedBody()));
}

template <int D>
double ContactProblem<D>::openingVelocity(const Pair& pair, const Approach<D>& approach,
                                          const std::vector<Body<D>>& bodies) const
{
    const int i = candidates_.body(pair.first);
    const int j = candidates_.secondBody(pair);
    double velocity = (bodies[j].velocity - bodies[i].velocity).dot(approach.normal);
    const auto turning = [&](int body, const Vector<D>& arm)
    { return spinVelocity(bodies[body].surfaceSpeed / data_.turning[body].length, arm).dot(approach.normal); };
    if (arrangement_.hasClusters())
    {
        velocity -= turning(i, arrangement_.firstArm(pair, approach));
        velocity += pair.second < 0 ? 0 : turning(j, arrangement_.secondArm(pair, approach));
    }
    const int wallBody = pair.second < 0 ? arrangement_.wallBody(~pair.second) : -1;
    if (wallBody >= 0)
    {
        const Vector<D> arm = arrangement_.contactPoint(pair, approach) - wallBodies_[wallBody].position;
        velocity += j != candidates_.fixedBody() ? turning(j, arm) : wallVelocity(wallBody, arm).dot(approach.normal);
    }
    return velocity;
}

template <int D>
Vector<D> ContactProblem<D>::wallVelocity(int wallBody, const Vector<D>& arm) const
{
    return wallBodies_[wallBody].velocity + spinVelocity(toTangent(wallBodies_[wallBody].spin), arm);
}

template <int D>
void ContactProblem<D>::addLevered(const Pair& pair, const Approach<D>& approach, const Impulse<D>& impulse, int j,
                                   const std::vector<Body<D>>& bodies)
{
    LeveredContact<D>& c = levered_.emplace_back();
    c.i = candidates_.body(pair.first);
    c.j = j;
    c.frame = contactFrame(approach.normal);
    c.turningI = data_.turning[c.i];
    c.armI = arrangement_.firstArm(pair, approach) / c.turningI.length;
    c.armJ.setZero();
    if (j < candidates_.fixedBody())
    {
        c.turningJ = data_.turning[j];
        const Vector<D> arm = pair.second >= 0 ? arrangement_.secondArm(pair, approach)
                                               : Vector<D>(arrangement_.contactPoint(pair, approach) -
                                                           wallBodies_[arrangement_.wallBody(~pair.second)].position);
        c.armJ = arm / c.turningJ.length;
    }
    const ContactParameters& parameters = arrangement_.parameters(pair);
    c.friction = parameters.friction;
    c.rollingLength = parameters.rolling * arrangement_.effectiveRadius(pair);
    c.impulse = c.frame.transpose() * impulseVector(approach.normal, impulse.normal, impulse.tangential);
    c.moment = inTangentPlane<D>(impulse.rolling, approach.normal);
    assemble(c, bodies[c.i].inverseMass + bodies[j].inverseMass);
}

template <int D>
template <class C>
double ContactProblem<D>::approachLimit(std::size_t p, double gap, const C& contact,
                                        const std::vector<Body<D>>& bodies) const
{
    const Pair& pair = candidates_.pairs()[p];
    const double restitution = arrangement_.parameters(pair).restitution;
    if (restitution > 0)
    {
        const auto before = [&](int body) -> const Body<D>&
        { return body < candidates_.fixedBody() ? data_.before[body] : bodies[body]; };
        const double velocity = normalVelocity(contact, before(contact.i), before(contact.j));
        if (velocity < 0 && gap + dt_ * velocity <= 0)
        {
            return restitution * velocity;
        }
    }
    const double open = loaded_[p] ? slack * arrangement_.radius(pair) : 0;
    return std::max(0.0, gap - open) / dt_;
}

template <int D>
double ContactProblem<D>::attraction(std::size_t p, double gap, const Impulse<D>& impulse) const
{
    const Pair& pair = candidates_.pairs()[p];
    const ContactParameters& parameters = arrangement_.parameters(pair);
    if (!loaded_[p] || impulse.age < parameters.cohesionDelay || gap > slack * arrangement_.radius(pair))
    {
        return 0;
    }
    return dt_ * (parameters.cohesion + parameters.tension * arrangement_.effectiveRadius(pair));
}

template <int D>
double ContactProblem<D>::findMissing(const std::vector<Body<D>>& bodies)
{
    double largest = 0;
    incomplete_ = false;
    for (std::size_t p = 0; p < kept_.size(); ++p)
    {
        if (kept_[p])
        {
            continue;
        }
        const Pair& pair = candidates_.pairs()[p];
        if (staysApart(pair, 0, bodies))
        {
            continue;
        }
        const auto approach = arrangement_.approach(pair);
        if (!approach)
        {
            continue;
        }
        const double penetration =
            -(openingVelocity(pair, *approach, bodies) + std::max(0.0, approach->gap) / dt_);
        if (penetration > 0)
        {
            kept_[p] = 1;
            incomplete_ = true;
            largest = std::max(largest, penetration);
        }
    }
    return largest;
}

template void ContactProblem<2>::clear();
template void ContactProblem<3>::clear();
template void ContactProblem<2>::begin(const std::vector<Impulse<2>>&, double);
template void ContactProblem<3>::begin(const std::vector<Impulse<3>>&, double);
template void ContactProblem<2>::choose(std::vector<Body<2>>&, const std::vector<Impulse<2>>&);
template void ContactProblem<3>::choose(std::vector<Body<3>>&, const std::vector<Impulse<3>>&);
template double ContactProblem<2>::findMissing(const std::vector<Body<2>>&);
template double ContactProblem<3>::findMissing(const std::vector<Body<3>>&);

}  // namespace nscd
