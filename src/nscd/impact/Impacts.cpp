// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The impacts of one group after another: when they happen and what they do.

#include "nscd/impact/Impacts.hpp"

namespace nscd
{

template <int D>
void Impacts<D>::work(int group, std::vector<Flyer<D>>& flyers, double until)
{
    const std::size_t first = begin_[group], last = begin_[group + 1];
    heap_.clear();
    for (std::size_t k = first; k < last; ++k)
    {
        const Item& item = items_[k];
        if (item.seen != flyers[item.i].impacts + flyers[item.j].impacts)
        {
            predict(k, flyers);
        }
        if (item.time <= until)
        {
            heap_.push_back({item.time, k, item.version});
        }
    }
    std::make_heap(heap_.begin(), heap_.end());
    double& energy = energy_[candidates_.groups()[group].first];
    while (!heap_.empty())
    {
        std::pop_heap(heap_.begin(), heap_.end());
        const Event event = heap_.back();
        heap_.pop_back();
        const Item& item = items_[event.item];
        if (event.version != item.version)
        {
            continue;
        }
        if (!collide(event.item, flyers, energy))
        {
            continue;
        }
        for (const int body : {item.i, item.j})
        {
            if (body >= candidates_.fixedBody())
            {
                continue;
            }
            constexpr int ahead = 4;
            const int end = touchingBegin_[body + 1];
            for (int t = touchingBegin_[body]; t < end; ++t)
            {
                const Touch& later = touching_[std::min(t + ahead, end - 1)];
                __builtin_prefetch(&items_[later.item]);
                __builtin_prefetch(&flyers[later.other]);
                const std::size_t k = touching_[t].item;
                if (k >= first && k < last)
                {
                    schedule(k, flyers, until);
                }
            }
        }
    }
}

template <int D>
void Impacts<D>::schedule(std::size_t k, const std::vector<Flyer<D>>& flyers, double until)
{
    predict(k, flyers);
    if (items_[k].time <= until)
    {
        heap_.push_back({items_[k].time, k, items_[k].version});
        std::push_heap(heap_.begin(), heap_.end());
    }
}

template <int D>
void Impacts<D>::predict(std::size_t k, const std::vector<Flyer<D>>& flyers)
{
    Item& item = items_[k];
    const Flyer<D>&a = flyers[item.i], &b = flyers[item.j];
    item.seen = a.impacts + b.impacts;
    ++item.version;
    const double now = std::max(a.clock, b.clock);
    item.time = item.touching > 0 ? predictRound(item, a, b, now, details_[k].met)
                                  : predictFlat(item, a, b, now, details_[k]);
}

template <int D>
double Impacts<D>::predictFlat(const Item& item, const Flyer<D>& a, const Flyer<D>& b, double now,
                               Details& details) const
{
    double speed = 0, gap = details.gap;
    if (details.lever >= 0)
    {
        const Lever& lever = levers_[details.lever];
        const Course course = courseOf(lever, a, b);
        speed = -course.velocity.dot(details.normal);
        gap += course.separation.dot(details.normal);
    }
    else
    {
        speed = -(b.body.velocity - a.body.velocity).dot(details.normal);
        gap += (b.offset - a.offset).dot(details.normal);
    }
    if (!(speed > item.slow && gap <= dt_ * speed))
    {
        return never;
    }
    details.met = gap > 0 ? gap / speed : 0;
    return std::max(now, details.met);
}

template <int D>
double Impacts<D>::predictRound(const Item& item, const Flyer<D>& a, const Flyer<D>& b, double now,
                                double& met) const
{
    const Vector<D> velocity = b.body.velocity - a.body.velocity;
    const Vector<D> separation = item.separation + (b.offset - a.offset) + now * velocity;
    const double closing = -separation.dot(velocity);
    const double outside = separation.squaredNorm() - item.touching * item.touching;
    if (closing <= 0 || outside > 2 * dt_ * closing)
    {
        return never;
    }
    const double square = velocity.squaredNorm();
    const double discriminant = closing * closing - square * outside;
    if (discriminant <= 0 || square <= 0)
    {
        return never;
    }
    const double root = std::sqrt(discriminant);
    if (root <= item.slow * item.touching)   // the normal velocity where they meet is root/touching
    {
        return never;
    }
    if (outside > 0)
    {
        met = now + outside / (closing + root);
        return met;
    }
    met = std::max(0.0, now + (closing - root) / square);
    return now;
}

template <int D>
bool Impacts<D>::collide(std::size_t k, std::vector<Flyer<D>>& flyers, double& energy)
{
    Item& item = items_[k];
    Details& details = details_[k];
    Flyer<D>&a = flyers[item.i], &b = flyers[item.j];
    LeveredContact<D> c;
    if (details.lever >= 0)
    {
        turnTo(details.met, item.i, a);
        turnTo(details.met, item.j, b);
        c = leveredContact(item, details, a, b);
        if (normalVelocity(c, a.body, b.body) + gainedBy(item, details.met).dot(c.normal()) >= 0)
        {
            item.time = never;
            return false;
        }
    }
    else if (details.law->rolling > 0)
    {
        c = roundContact(item, details, a, b);
    }
    const Body<D> beforeA = a.body, beforeB = b.body;
    energy += details.law->rolling > 0 ? collideRolling(item, details, c, a, b)
              : details.lever >= 0     ? collideLevered(item, details, c, a, b)
                                       : collidePlain(item, details, a, b);
    divert(item.i, flyers, beforeA, details.met, item.time);
    divert(item.j, flyers, beforeB, details.met, item.time);
    ++details.impacts;
    ++count_;
    if (details.impacts == mostImpacts)
    {
        ++exhausted_;
        item.slow = never;
    }
    return true;
}

template <int D>
Vector<D> Impacts<D>::normalOf(const Item& item, const Details& details, const Flyer<D>& a, const Flyer<D>& b) const
{
    if (item.touching <= 0)
    {
        return details.normal;
    }
    const Vector<D> separation = item.separation + (b.offset - a.offset) +
                                 details.met * (b.body.velocity - a.body.velocity);
    const double distance = separation.norm();
    return distance > 0 ? Vector<D>(separation / distance) : details.normal;
}

template <int D>
double Impacts<D>::collidePlain(const Item& item, Details& details, Flyer<D>& a, Flyer<D>& b)
{
    const Vector<D> normal = normalOf(item, details, a, b);
    const Vector<D> before = b.body.velocity - a.body.velocity;
    const Vector<D> more = gainedBy(item, details.met);
    const Vector<D> relative = before + more;
    const double e = restitution(details, -relative.dot(normal));
    const Contact<D> c = centralImpact<D>(normal, relative, a.body, b.body, details.law->friction, e);
    const Tangent<D> slipBefore = slip(c, a.body, b.body, relative);
    apply<D>(c, a.body, b.body, c.normalImpulse, c.slipImpulse);
    const Vector<D> after = b.body.velocity - a.body.velocity + more;
    const Vector<D> impulse = impulseVector(normal, c.normalImpulse, c.slipImpulse);
    details.given += impulse;
    details.pressed += c.normalImpulse;
    const Tangent<D> slips = slipBefore + slip(c, a.body, b.body, after);
    return 0.5 * (c.normalImpulse * (relative + after).dot(normal) + product(c.slipImpulse, slips)) -
           workOnDriven(b, impulse);
}

template <int D>
double Impacts<D>::collideLevered(const Item& item, Details& details, const LeveredContact<D>& c, Flyer<D>& a,
                                  Flyer<D>& b)
{
    const Vector<D> more = gainedBy(item, details.met);
    const Vector<D> velocity = c.frame.transpose() * Vector<D>(relativeVelocity(c, a.body, b.body) + more);
    const Vector<D> r =
        impactImpulse<D>(c.w, velocity, details.law->friction, restitution(details, -velocity[0]));
    const Vector<D> impulse = c.frame * r;
    apply<D>(c, a.body, b.body, impulse, zeroTangent<D>());
    details.given += impulse;
    details.pressed += r[0];
    return nscd::work<D>(c.w, velocity, r) - workOnDriven(b, impulse);
}

template <int D>
LeveredContact<D> Impacts<D>::roundContact(const Item& item, const Details& details, const Flyer<D>& a,
                                           const Flyer<D>& b) const
{
    LeveredContact<D> c{};
    c.i = item.i;
    c.j = item.j;
    const Vector<D> normal = normalOf(item, details, a, b);
    c.frame = contactFrame(normal);
    c.turningI = data_.turning[c.i];
    c.armI = normal;   // over the radius
    c.armJ.setZero();
    if (item.touching > 0)
    {
        c.turningJ = data_.turning[c.j];
        c.armJ = -normal;
    }
    assemble(c, normalW(a.body, b.body));
    return c;
}

template <int D>
double Impacts<D>::collideRolling(const Item& item, Details& details, LeveredContact<D> c, Flyer<D>& a,
                                  Flyer<D>& b)
{
    c.friction = details.law->friction;
    c.rollingLength = details.law->rolling * arrangement_.effectiveRadius(candidates_.pairs()[details.pair]);
    c.moment = zeroTangent<D>();
    const Vector<D> more = gainedBy(item, details.met);
    const Vector<D> relative = relativeVelocity(c, a.body, b.body) + more;
    const Tangent<D> rate = rollingRate(c, a.body, b.body);
    const Vector<D> velocity = c.frame.transpose() * relative;
    c.impulse = impactImpulse<D>(c.w, velocity, c.friction, restitution(details, -velocity[0]));
    apply<D>(c, a.body, b.body, c.frame * c.impulse, zeroTangent<D>());
    resistRolling<D>(c, a.body, b.body, more);
    const Vector<D> impulse = c.frame * c.impulse;
    details.given += impulse;
    details.pressed += c.impulse[0];
    details.rolled += c.moment;
    const Vector<D> after = relativeVelocity(c, a.body, b.body) + more;
    const Tangent<D> rates = rate + rollingRate(c, a.body, b.body);
    return 0.5 * (impulse.dot(relative + after) + product(c.moment, rates)) - workOnDriven(b, impulse, c.moment);
}

template <int D>
double Impacts<D>::restitution(const Details& details, double approach) const
{
    const double dry = details.law->restitution;
    return details.viscous > 0 && approach > 0 ? wet_(dry, approach / details.viscous) : dry;
}

template <int D>
Vector<D> Impacts<D>::gainedBy(const Item& item, double time) const
{
    const std::vector<Launch<D>>& launches = *launches_;
    const bool isDriven = item.j >= static_cast<int>(launches.size());
    const Vector<D> push = isDriven ? Vector<D>(-launches[item.i].push)
                                    : Vector<D>(launches[item.j].push - launches[item.i].push);
    return (time / dt_ - 0.5) * push;
}

template <int D>
double Impacts<D>::workOnDriven(const Flyer<D>& b, const Vector<D>& impulse, const Tangent<D>& moment)
{
    return b.body.inverseMass > 0 ? 0 : impulse.dot(b.body.velocity) + product(moment, b.body.surfaceSpeed);
}

template <int D>
void Impacts<D>::divert(int body, std::vector<Flyer<D>>& flyers, const Body<D>& before, double met,
                        double time) const
{
    if (body >= candidates_.fixedBody())
    {
        return;
    }
    Flyer<D>& f = flyers[body];
    const Launch<D>& launch = (*launches_)[body];
    f.farthest = std::max(f.farthest, way(f, before, launch, met));
    f.offset += met * (before.velocity - f.body.velocity);
    f.turned += met * (before.surfaceSpeed - f.body.surfaceSpeed);
    f.clock = std::max(f.clock, time);
    ++f.impacts;
}

template void Impacts<2>::work(int, std::vector<Flyer<2>>&, double);
template void Impacts<3>::work(int, std::vector<Flyer<3>>&, double);
template void Impacts<2>::predict(std::size_t, const std::vector<Flyer<2>>&);
template void Impacts<3>::predict(std::size_t, const std::vector<Flyer<3>>&);

}  // namespace nscd
