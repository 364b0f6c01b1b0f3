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
constexpr double safeGap = 0.02;

/// An overlap deeper than this fraction of the smaller radius is removed in several steps, so that the grains
/// nearby are noticed in time.
constexpr double largestPush = 0.1;

/// A contact that carried an impulse in the last sub-step may open by this fraction of the smaller radius before its
/// grains may approach again.  Otherwise the gaps that the removal of overlaps opens next to them close under the
/// load, step after step, and a deep pile whose impulses do not converge sinks into itself (doc/theory, eq. 5.8).
constexpr double slack = 5e-3;

/// Part of the slack that grains which attract each other may open: they move along chords, which opens a pair that
/// turns in every step, and beyond the slack there is no attraction (doc/theory, eq. 5.23).
constexpr double attractedSlack = 0.5;

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
void ContactProblem<D>::begin(const std::vector<Impulse<D>>& impulses, double dt, std::vector<char> goesOn)
{
    dt_ = dt;
    incomplete_ = false;
    loaded_ = std::move(goesOn);
    loaded_.resize(impulses.size(), 0);
    std::transform(impulses.begin(), impulses.end(), loaded_.begin(), loaded_.begin(),
                   [](const Impulse<D>& impulse, char loaded) { return impulse.normal > 0 || loaded; });
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
            if (!kept_[p] && staysApart(pair, safeGap * radius, bodies))
            {
                continue;
            }
            const auto met = meeting(p);
            if (!met)
            {
                continue;
            }
            const auto& [approach, gap] = *met;
            const int i = candidates_.body(pair.first);
            if (gap + dt_ * openingVelocity(pair, approach, bodies) >= safeGap * radius && !kept_[p])
            {
                continue;
            }
            kept_[p] = 1;
            const int j = secondBody(pair, approach, bodies);
            // A flight may lead into another body or, back to the beginning, out of one: that is no overlap
            const bool isDeep = std::max(gap, approach.gap) < -largestPush * radius;
            const Origin origin{p, isDeep ? -largestPush * radius : gap, attraction(p, gap, impulses[p]), gap};
            const double limit = approachLimit(p, gap, origin.attraction > 0);
            // An attraction that begins or ends moves nothing by itself
            Impulse<D> start = impulses[p];
            start.normal = std::max(0.0, start.normal + origin.attraction - start.attraction);
            if (isLevered(pair))
            {
                addLevered(pair, approach, start, j, bodies);
                levered_.back().approachLimit = limit;
                leveredOrigin_.push_back(origin);
                continue;
            }
            contacts_.push_back({approach.normal, limit,
                                 1 / normalW(bodies[i], bodies[j]),
                                 arrangement_.parameters(pair).friction, start.normal,
                                 inTangentPlane<D>(start.tangential, approach.normal), i, j});
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
    bodies.push_back({wallVelocity(wallBody, arm), isLevered(pair) ? toTangent(wall.spin) : zeroTangent<D>(), 0, 0});
    return static_cast<int>(bodies.size()) - 1;
}

template <int D>
bool ContactProblem<D>::staysApart(const Pair& pair, double apart, const std::vector<Body<D>>& bodies,
                                   const Vector<D>& besides) const
{
    if (arrangement_.hasClusters() || (pair.second < 0 && arrangement_.wallBody(~pair.second) >= 0))
    {
        return false;
    }
    const int i = candidates_.body(pair.first), j = candidates_.secondBody(pair);
    Vector<D> motion = dt_ * (bodies[j].velocity - bodies[i].velocity + besides);
    if (!data_.ahead.empty())
    {
        motion -= dt_ * (data_.ahead[j].velocity - data_.ahead[i].velocity);
    }
    return arrangement_.staysApart(pair, apart, motion);
}

template <int D>
std::optional<typename ContactProblem<D>::Meeting> ContactProblem<D>::meeting(std::size_t p) const
{
    const Pair& pair = candidates_.pairs()[p];
    const auto approach = arrangement_.approach(pair);
    if (!approach)
    {
        return {};
    }
    if (!data_.flight.empty() && !loaded_[p] && pair.second >= 0 && !arrangement_.isOfCluster(pair) &&
        arrangement_.parameters(pair).restitution > 0)
    {
        return meetingAtEnd(pair, *approach);
    }
    const double way = data_.ahead.empty() ? 0 : dt_ * openingByBodies(pair, *approach, data_.ahead);
    return Meeting{*approach, approach->gap - way};
}

template <int D>
typename ContactProblem<D>::Meeting ContactProblem<D>::meetingAtEnd(const Pair& pair,
                                                                    const Approach<D>& approach) const
{
    const int i = candidates_.body(pair.first), j = candidates_.body(pair.second);
    const Vector<D> flight = dt_ * (data_.flight[j].velocity - data_.flight[i].velocity);
    const double touching = arrangement_.sumOfRadii(pair);
    Vector<D> separation = (approach.gap + touching) * approach.normal + flight;
    if (!data_.ahead.empty())
    {
        separation -= dt_ * (data_.ahead[j].velocity - data_.ahead[i].velocity);
    }
    const double distance = separation.norm();
    const Vector<D> normal =
        separation.dot(approach.normal) > 0 ? Vector<D>(separation / distance) : approach.normal;
    const double gap = separation.dot(normal) - touching;
    return {{normal, gap}, gap - flight.dot(normal)};
}

template <int D>
bool ContactProblem<D>::isLevered(const Pair& pair) const
{
    return !data_.turning.empty() &&
           (arrangement_.isOfCluster(pair) || arrangement_.parameters(pair).rolling > 0 ||
            (pair.second < 0 && candidates_.secondBody(pair) != candidates_.fixedBody()));
}

template <int D>
double ContactProblem<D>::openingByBodies(const Pair& pair, const Approach<D>& approach,
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
    if (pair.second < 0 && j != candidates_.fixedBody())
    {
        velocity += turning(j, wallArm(pair, approach, j));
    }
    return velocity;
}

template <int D>
double ContactProblem<D>::openingVelocity(const Pair& pair, const Approach<D>& approach,
                                          const std::vector<Body<D>>& bodies) const
{
    const double velocity = openingByBodies(pair, approach, bodies);
    const int wallBody = pair.second < 0 ? arrangement_.wallBody(~pair.second) : -1;
    if (wallBody < 0 || candidates_.secondBody(pair) != candidates_.fixedBody())
    {
        return velocity;
    }
    const Vector<D> arm = arrangement_.contactPoint(pair, approach) - wallBodies_[wallBody].position;
    return velocity + wallVelocity(wallBody, arm).dot(approach.normal);
}

template <int D>
Vector<D> ContactProblem<D>::wallArm(const Pair& pair, const Approach<D>& approach, int body) const
{
    Vector<D> centre = wallBodies_[arrangement_.wallBody(~pair.second)].position;
    if (!data_.ahead.empty())
    {
        centre += dt_ * data_.ahead[body].velocity;
    }
    return arrangement_.contactPoint(pair, approach) - centre;
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
        const Vector<D> arm =
            pair.second >= 0 ? arrangement_.secondArm(pair, approach) : wallArm(pair, approach, j);
        c.armJ = arm / c.turningJ.length;
    }
    const ContactParameters& parameters = arrangement_.parameters(pair);
    c.friction = parameters.friction;
    c.rollingLength = parameters.rolling * arrangement_.effectiveRadius(pair);
    c.impulse = c.frame.transpose() * impulseVector(approach.normal, impulse.normal, impulse.tangential);
    c.moment = inTangentPlane<D>(impulse.rolling, approach.normal);
    assemble(c, normalW(bodies[c.i], bodies[j]));
}

template <int D>
double ContactProblem<D>::approachLimit(std::size_t p, double gap, bool attracts) const
{
    const double share = !loaded_[p] ? 0 : attracts ? attractedSlack * slack : slack;
    return std::max(0.0, gap - share * arrangement_.radius(candidates_.pairs()[p])) / dt_;
}

template <int D>
double ContactProblem<D>::attraction(std::size_t p, double gap, const Impulse<D>& impulse) const
{
    const Pair& pair = candidates_.pairs()[p];
    const ContactParameters& parameters = arrangement_.parameters(pair);
    if (!loaded_[p] || impulse.age < parameters.cohesionDelay || gap > slack * arrangement_.radius(pair) ||
        arrangement_.ambient(pair) >= parameters.cohesionBelow)
    {
        return 0;
    }
    return dt_ * (parameters.cohesion + parameters.tension * arrangement_.effectiveRadius(pair));
}

template <int D>
std::optional<typename ContactProblem<D>::Opening>
ContactProblem<D>::openingOf(std::size_t p, const std::vector<Body<D>>& bodies, const Vector<D>& besides) const
{
    const Pair& pair = candidates_.pairs()[p];
    if (staysApart(pair, 0, bodies, besides))
    {
        return {};
    }
    const auto met = meeting(p);
    if (!met)
    {
        return {};
    }
    return Opening{met->approach.normal, openingVelocity(pair, met->approach, bodies), met->gap};
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
        const auto opening = openingOf(p, bodies);
        if (!opening)
        {
            continue;
        }
        // Those that diverge after an impact would have overlapped before it
        const double gap = data_.ahead.empty() ? std::max(0.0, opening->gap) : opening->gap;
        const double penetration = -(opening->velocity + gap / dt_);
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
template void ContactProblem<2>::begin(const std::vector<Impulse<2>>&, double, std::vector<char>);
template void ContactProblem<3>::begin(const std::vector<Impulse<3>>&, double, std::vector<char>);
template void ContactProblem<2>::choose(std::vector<Body<2>>&, const std::vector<Impulse<2>>&);
template void ContactProblem<3>::choose(std::vector<Body<3>>&, const std::vector<Impulse<3>>&);
template std::optional<ContactProblem<2>::Opening> ContactProblem<2>::openingOf(std::size_t,
                                                                                const std::vector<Body<2>>&,
                                                                                const Vector<2>&) const;
template std::optional<ContactProblem<3>::Opening> ContactProblem<3>::openingOf(std::size_t,
                                                                                const std::vector<Body<3>>&,
                                                                                const Vector<3>&) const;
template double ContactProblem<2>::findMissing(const std::vector<Body<2>>&);
template double ContactProblem<3>::findMissing(const std::vector<Body<3>>&);

}  // namespace nscd
