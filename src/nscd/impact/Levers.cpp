// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Impacts of clusters and free walls: where and how they meet at a time of their flight.

#include "nscd/base/Rotation.hpp"
#include "nscd/impact/Impacts.hpp"

namespace nscd
{

template <int D>
auto Impacts<D>::courseOf(const Lever& lever, const Flyer<D>& a, const Flyer<D>& b) const -> Course
{
    const Vector<D> first = a.orientation * lever.first, second = b.orientation * lever.second;
    const Vector<D> ofFirst = spinVelocity(Tangent<D>(a.body.surfaceSpeed / lever.lengthFirst), first);
    const Vector<D> ofSecond = spinVelocity(Tangent<D>(b.body.surfaceSpeed / lever.lengthSecond), second);
    const Vector<D> turned = (second - lever.startSecond) - (first - lever.startFirst);
    return {b.offset - a.offset + turned - b.since * ofSecond + a.since * ofFirst,
            b.body.velocity - a.body.velocity + ofSecond - ofFirst};
}

template <int D>
LeveredContact<D> Impacts<D>::leveredContact(const Item& item, const Details& details, const Flyer<D>& a,
                                             const Flyer<D>& b) const
{
    const Lever& lever = levers_[details.lever];
    const Vector<D> first = a.orientation * lever.first, second = b.orientation * lever.second;
    const Vector<D> between = (details.gap + lever.touching) * details.normal + (b.offset - a.offset) +
                              details.met * (b.body.velocity - a.body.velocity) +
                              (second - lever.startSecond) - (first - lever.startFirst);
    const double distance = between.norm();
    const Vector<D> normal =
        lever.isWall || distance <= 0 ? details.normal : Vector<D>(between / distance);

    // One point for both, in the middle of what is left of the gap
    const double middle = lever.radius + 0.5 * (between.dot(normal) - lever.touching);
    LeveredContact<D> c{};
    c.i = item.i;
    c.j = item.j;
    c.frame = contactFrame(normal);
    c.turningI = turningAt(c.i, a);
    c.armI = (first + middle * normal) / c.turningI.length;
    c.armJ.setZero();
    if (c.j < candidates_.fixedBody())
    {
        c.turningJ = turningAt(c.j, b);
        c.armJ = (second - between + middle * normal) / c.turningJ.length;
    }
    assemble(c, normalW(a.body, b.body));
    return c;
}

template <int D>
void Impacts<D>::turnTo(double time, int body, Flyer<D>& flyer) const
{
    if (!turns(body))
    {
        return;
    }
    const double length = data_.turning[body].length;
    Spin<D> spin = toSpin(flyer.body.surfaceSpeed) / length;
    turn(flyer.orientation, spin, data_.inertia[body], time - flyer.since);
    flyer.body.surfaceSpeed = toTangent(Spin<D>(length * spin));
    flyer.since = time;
}

template <int D>
Turning<D> Impacts<D>::turningAt(int body, const Flyer<D>& flyer) const
{
    const Turning<D>& start = data_.turning[body];
    if (!turns(body))
    {
        return start;
    }
    return {start.length, inSpace(flyer.orientation, Spin<D>(data_.inertia[body].cwiseInverse()))};
}

template auto Impacts<2>::courseOf(const Lever&, const Flyer<2>&, const Flyer<2>&) const -> Course;
template LeveredContact<2> Impacts<2>::leveredContact(const Item&, const Details&, const Flyer<2>&,
                                                      const Flyer<2>&) const;
template void Impacts<2>::turnTo(double, int, Flyer<2>&) const;
template auto Impacts<3>::courseOf(const Lever&, const Flyer<3>&, const Flyer<3>&) const -> Course;
template LeveredContact<3> Impacts<3>::leveredContact(const Item&, const Details&, const Flyer<3>&,
                                                      const Flyer<3>&) const;
template void Impacts<3>::turnTo(double, int, Flyer<3>&) const;

}  // namespace nscd
