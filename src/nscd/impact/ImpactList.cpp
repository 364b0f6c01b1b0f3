// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which candidates may have impacts in a sub-step, and with what data.

#include "nscd/impact/Impacts.hpp"

namespace nscd
{

template <int D>
void Impacts<D>::clear()
{
    items_.clear();
    details_.clear();
    levers_.clear();
    begin_.clear();
    given_.clear();
    energy_.assign(candidates_.blocks(), 0.0);
    count_ = exhausted_ = 0;
}

template <int D>
bool Impacts<D>::begin(std::vector<Flyer<D>>& flyers, const std::vector<Launch<D>>& launches,
                       const std::vector<Impulse<D>>& impulses, double dt, double resolved,
                       const Vector<D>& usual, double fastest)
{
    clear();
    launches_ = &launches;
    dt_ = dt;
    resolved_ = resolved;
    usual_ = usual;
    fastest_ = fastest;
    for (const Group& group : candidates_.groups())
    {
        begin_.push_back(items_.size());
        list(group, flyers, launches, impulses);
    }
    begin_.push_back(items_.size());
    bool any = false;
    for (std::size_t k = 0; k < items_.size(); ++k)
    {
        predict(k, flyers);
        any = any || items_[k].time <= dt;
    }
    listTouching(flyers.size());
    return any;
}

template <int D>
void Impacts<D>::list(const Group& group, std::vector<Flyer<D>>& flyers, const std::vector<Launch<D>>& launches,
                      const std::vector<Impulse<D>>& impulses)
{
    const double reach = 2 * dt_ * fastest_;
    for (std::size_t p = group.begin; p < group.end; ++p)
    {
        const Pair& pair = candidates_.pairs()[p];
        const ContactParameters& law = arrangement_.parameters(pair);
        const bool isWall = pair.second < 0;
        const int wallBody = isWall ? arrangement_.wallBody(~pair.second) : -1;
        const int second = candidates_.secondBody(pair);
        double closest = isWall ? dt_ * (fastest_ + (usual_ - flyers[second].body.velocity).norm()) : reach;
        const bool isOfMovingWall = wallBody >= 0 && second == candidates_.fixedBody();
        if (law.restitution <= 0 || (!isOfMovingWall && arrangement_.staysApart(pair, closest, Vector<D>::Zero())))
        {
            continue;
        }
        const auto approach = arrangement_.approach(pair);
        if (!approach || (!isOfMovingWall && approach->gap > closest))
        {
            continue;
        }
        Item item{never, candidates_.body(pair.first), second, 0, 0, Vector<D>::Zero(), 0, 0};
        Details details{p, approach->normal, approach->gap, &law};
        Vector<D> push = -launches[item.i].push;
        item.slow = share * push.norm() + (impulses[p].normal > 0 ? resolved_ : 0);
        if (item.j < candidates_.fixedBody())
        {
            push += launches[item.j].push;
            item.slow += share * launches[item.j].push.norm();
        }
        item.slow = std::max(item.slow, normalShare * std::abs(push.dot(details.normal)));
        if (isOfMovingWall)
        {
            const WallBody<D>& wall = wallBodies_[wallBody];
            const Vector<D> arm = arrangement_.contactPoint(pair, *approach) - wall.position;
            Flyer<D> point;
            // The velocity is that at the contact: only resistance to rolling asks for the spin besides
            const Tangent<D> spin = law.rolling > 0 ? toTangent(wall.spin) : zeroTangent<D>();
            point.body = {wall.velocity + spinVelocity(toTangent(wall.spin), arm), spin, 0, 0};
            closest = dt_ * (fastest_ + (usual_ - point.body.velocity).norm());
            item.j = static_cast<int>(flyers.size());
            flyers.push_back(point);
        }
        if (approach->gap > closest)
        {
            continue;
        }
        if (!data_.turning.empty() &&
            (arrangement_.isOfCluster(pair) || (isWall && item.j < candidates_.fixedBody())))
        {
            addLever(item, details, pair, *approach, flyers);
        }
        else if (!isWall)
        {
            item.touching = arrangement_.sumOfRadii(pair);
            item.separation = (details.gap + item.touching) * details.normal;
        }
        details.viscous = wet_ ? viscousSpeed(item, pair, flyers) : 0;
        items_.push_back(item);
        details_.push_back(details);
    }
}

template <int D>
double Impacts<D>::viscousSpeed(const Item& item, const Pair& pair, const std::vector<Flyer<D>>& flyers) const
{
    const std::vector<Launch<D>>& launches = *launches_;
    const double first = launches[item.i].viscosity;
    const double second = pair.second < 0 ? first : launches[item.j].viscosity;
    const double a = arrangement_.effectiveRadius(pair);
    return 6 * M_PI * a * a *
           (first * flyers[item.i].body.inverseMass + second * flyers[item.j].body.inverseMass);
}

template <int D>
void Impacts<D>::addLever(const Item& item, Details& details, const Pair& pair, const Approach<D>& approach,
                          const std::vector<Flyer<D>>& flyers)
{
    details.lever = static_cast<int>(levers_.size());
    Lever& lever = levers_.emplace_back();
    lever.isWall = pair.second < 0;
    lever.radius = arrangement_.radiusOf(pair.first);
    lever.touching = lever.isWall ? lever.radius : arrangement_.sumOfRadii(pair);
    lever.lengthFirst = data_.turning[item.i].length;
    lever.lengthSecond = item.j < candidates_.fixedBody() ? data_.turning[item.j].length : 1;
    lever.startFirst = arrangement_.arm(pair.first);
    lever.startSecond.setZero();
    if (!lever.isWall)
    {
        lever.startSecond = arrangement_.arm(pair.second);
    }
    else if (item.j < candidates_.fixedBody())
    {
        const Vector<D> onWall =
            arrangement_.contactPoint(pair, approach) + std::min(0.0, 0.5 * approach.gap) * approach.normal;
        lever.startSecond = onWall - wallBodies_[arrangement_.wallBody(~pair.second)].position;
    }
    lever.first = flyers[item.i].orientation.inverse() * lever.startFirst;
    lever.second = flyers[item.j].orientation.inverse() * lever.startSecond;
}

template <int D>
void Impacts<D>::listTouching(std::size_t bodies)
{
    touchingBegin_.assign(bodies + 1, 0);
    for (const Item& item : items_)
    {
        ++touchingBegin_[item.i + 1];
        ++touchingBegin_[item.j + 1];
    }
    for (std::size_t b = 0; b < bodies; ++b)
    {
        touchingBegin_[b + 1] += touchingBegin_[b];
    }
    touching_.resize(touchingBegin_[bodies]);
    std::vector<int> next(touchingBegin_.begin(), touchingBegin_.end() - 1);
    for (std::size_t k = 0; k < items_.size(); ++k)
    {
        const Item& item = items_[k];
        touching_[next[item.i]++] = {static_cast<int>(k), item.j};
        touching_[next[item.j]++] = {static_cast<int>(k), item.i};
    }
}

template <int D>
void Impacts<D>::collectImpulses()
{
    for (const Details& details : details_)
    {
        if (details.impacts > 0)
        {
            given_.push_back({details.pair, details.normal, details.gap, details.given, details.pressed,
                              details.impacts, details.rolled});
        }
    }
}

template class Impacts<2>;
template class Impacts<3>;

}  // namespace nscd
