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
        const Watched& w = watched_[k];
        if (w.seenI != flyers[w.i].impacts || w.seenJ != flyers[w.j].impacts)
        {
            predict(k, flyers);
        }
        if (w.time <= until)
        {
            heap_.push_back({w.time, k, w.version});
        }
    }
    std::make_heap(heap_.begin(), heap_.end());
    double& energy = energy_[candidates_.groups()[group].first];
    while (!heap_.empty())
    {
        std::pop_heap(heap_.begin(), heap_.end());
        const Event event = heap_.back();
        heap_.pop_back();
        const Watched& w = watched_[event.item];
        if (event.version != w.version)
        {
            continue;
        }
        collide(event.item, flyers, energy);
        for (const int body : {w.i, w.j})
        {
            if (body >= candidates_.fixedBody())
            {
                continue;
            }
            for (int t = touchingBegin_[body]; t < touchingBegin_[body + 1]; ++t)
            {
                const std::size_t k = touching_[t];
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
    if (watched_[k].time <= until)
    {
        heap_.push_back({watched_[k].time, k, watched_[k].version});
        std::push_heap(heap_.begin(), heap_.end());
    }
}

template <int D>
void Impacts<D>::predict(std::size_t k, const std::vector<Flyer<D>>& flyers)
{
    Watched& w = watched_[k];
    Item& item = items_[k];
    const Flyer<D>&a = flyers[w.i], &b = flyers[w.j];
    w.seenI = a.impacts;
    w.seenJ = b.impacts;
    ++w.version;
    w.time = never;
    if (item.impacts >= mostImpacts)
    {
        return;
    }
    const double now = std::max(a.clock, b.clock);
    if (item.touching > 0)
    {
        w.time = predictRound(item, a, b, now);
        return;
    }
    double speed = 0, gap = item.gap;
    if (item.lever >= 0)
    {
        const LeveredContact<D>& c = levers_[item.lever];
        speed = -normalVelocity(c, a.body, b.body);
        gap += (b.offset - a.offset + spinVelocity(b.turned, c.armJ) - spinVelocity(a.turned, c.armI))
                   .dot(item.normal);
    }
    else
    {
        speed = -(b.body.velocity - a.body.velocity).dot(item.normal);
        gap += (b.offset - a.offset).dot(item.normal);
    }
    if (speed > item.slow && gap <= dt_ * speed)
    {
        item.met = gap > 0 ? gap / speed : 0;
        w.time = std::max(now, item.met);
    }
}

template <int D>
double Impacts<D>::predictRound(Item& item, const Flyer<D>& a, const Flyer<D>& b, double now) const
{
    const Vector<D> velocity = b.body.velocity - a.body.velocity;
    const Vector<D> separation =
        (item.gap + item.touching) * item.normal + (b.offset - a.offset) + now * velocity;
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
        item.met = now + outside / (closing + root);
        return item.met;
    }
    item.met = std::max(0.0, now + (closing - root) / square);
    return now;
}

template <int D>
void Impacts<D>::collide(std::size_t k, std::vector<Flyer<D>>& flyers, double& energy)
{
    Item& item = items_[k];
    Flyer<D>&a = flyers[item.i], &b = flyers[item.j];
    const Body<D> beforeA = a.body, beforeB = b.body;
    energy += item.lever >= 0 ? collideLevered(item, a, b) : collidePlain(item, a, b);
    divert(item.i, flyers, beforeA, item.met, watched_[k].time);
    divert(item.j, flyers, beforeB, item.met, watched_[k].time);
    ++item.impacts;
    ++count_;
    exhausted_ += item.impacts == mostImpacts;
}

template <int D>
double Impacts<D>::collidePlain(Item& item, Flyer<D>& a, Flyer<D>& b)
{
    Vector<D> normal = item.normal;
    const Vector<D> before = b.body.velocity - a.body.velocity;
    if (item.touching > 0)
    {
        const Vector<D> separation =
            (item.gap + item.touching) * item.normal + (b.offset - a.offset) + item.met * before;
        const double distance = separation.norm();
        normal = distance > 0 ? Vector<D>(separation / distance) : normal;
    }
    const Contact<D> c = centralImpact<D>(normal, a.body, b.body, item.law->friction, item.law->restitution);
    const Tangent<D> slipBefore = slip(c, a.body, b.body, before);
    apply<D>(c, a.body, b.body, c.normalImpulse, c.slipImpulse);
    const Vector<D> after = b.body.velocity - a.body.velocity;
    const Vector<D> impulse = impulseVector(normal, c.normalImpulse, c.slipImpulse);
    item.given += impulse;
    item.pressed += c.normalImpulse;
    const Tangent<D> slips = slipBefore + slip(c, a.body, b.body, after);
    return 0.5 * (c.normalImpulse * (before + after).dot(normal) + product(c.slipImpulse, slips)) -
           workOnDriven(b, impulse);
}

template <int D>
double Impacts<D>::collideLevered(Item& item, Flyer<D>& a, Flyer<D>& b)
{
    const LeveredContact<D>& c = levers_[item.lever];
    const Vector<D> velocity = c.frame.transpose() * relativeVelocity(c, a.body, b.body);
    const Vector<D> r = impactImpulse<D>(c.w, velocity, item.law->friction, item.law->restitution);
    const Vector<D> impulse = c.frame * r;
    apply<D>(c, a.body, b.body, impulse, zeroTangent<D>());
    item.given += impulse;
    item.pressed += r[0];
    return nscd::work<D>(c.w, velocity, r) - workOnDriven(b, impulse);
}

template <int D>
double Impacts<D>::workOnDriven(const Flyer<D>& b, const Vector<D>& impulse)
{
    return b.body.inverseMass > 0 ? 0 : impulse.dot(b.body.velocity);
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
