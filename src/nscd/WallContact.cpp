// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/WallContact.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

double cross(const Vector<2>& a, const Vector<2>& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

const Vector<2>& endPoint(const Segment& wall, int end)
{
    return end == 0 ? wall.a : wall.b;
}

/// Which end a projection has run beyond: 0, 1, or -1 for none.
int endBeyond(double projection)
{
    return projection <= 0 ? 0 : projection >= 1 ? 1 : -1;
}

}  // namespace

WallContact<2>::WallContact(const Walls<2>& walls)
    : walls_(walls), neighbours_(walls.size())
{
    double longest = 0;
    std::vector<End> ends;
    std::vector<Bounds<2>> boxes;
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        longest = std::max(longest, (walls[w].b - walls[w].a).norm());
        boxes.push_back({walls[w].a.cwiseMin(walls[w].b), walls[w].a.cwiseMax(walls[w].b)});
        ends.push_back({static_cast<int>(w), 0});
        ends.push_back({static_cast<int>(w), 1});
    }
    tree_ = BoxTree<2>(boxes, std::vector<int>(walls.size(), 0));
    const double same = 1e-9 * longest;
    const auto point = [&](const End& e) -> const Vector<2>& { return endPoint(walls_[e.wall], e.end); };
    std::sort(ends.begin(), ends.end(), [&](const End& p, const End& q) { return point(p).x() < point(q).x(); });
    for (std::size_t p = 0; p < ends.size(); ++p)
    {
        for (std::size_t q = p + 1; q < ends.size() && point(ends[q]).x() - point(ends[p]).x() <= same; ++q)
        {
            if ((point(ends[q]) - point(ends[p])).norm() <= same && ends[p].wall != ends[q].wall)
            {
                neighbours_[ends[p].wall][ends[p].end].push_back(ends[q]);
                neighbours_[ends[q].wall][ends[q].end].push_back(ends[p]);
            }
        }
    }
}

double WallContact<2>::projection(int wall, const Vector<2>& x) const
{
    const Vector<2> along = walls_[wall].b - walls_[wall].a;
    return (x - walls_[wall].a).dot(along) / along.squaredNorm();
}

double WallContact<2>::distance(int wall, const Vector<2>& x) const
{
    const double t = std::min(1.0, std::max(0.0, projection(wall, x)));
    return (walls_[wall].a + t * (walls_[wall].b - walls_[wall].a) - x).norm();
}

Approach<2> WallContact<2>::approachPoint(const Vector<2>& point, int wall, const Vector<2>& centre,
                                          double radius) const
{
    const Vector<2> toWall = point - centre;
    const double distance = toWall.norm();
    if (distance > 0)
    {
        return {toWall / distance, distance - radius};
    }
    const Vector<2> along = (walls_[wall].b - walls_[wall].a).normalized();
    return {Vector<2>(along.y(), -along.x()), -radius};   // centre on the wall: push it to the left of a -> b
}

std::optional<Approach<2>> WallContact<2>::approach(int wall, const Vector<2>& centre, double radius) const
{
    const double t = projection(wall, centre);
    const int end = endBeyond(t);
    if (end < 0)
    {
        return approachPoint(walls_[wall].a + t * (walls_[wall].b - walls_[wall].a), wall, centre, radius);
    }
    return approachJoint(wall, end, centre, radius);
}

std::optional<Approach<2>> WallContact<2>::approachJoint(int wall, int end, const Vector<2>& centre,
                                                         double radius) const
{
    const Vector<2>& joint = endPoint(walls_[wall], end);
    bool first = true;
    for (const End& other : neighbours_[wall][end])
    {
        if (endBeyond(projection(other.wall, centre)) == other.end)
        {
            first = first && wall < other.wall;
            continue;
        }
        const Vector<2> alongOther = endPoint(walls_[other.wall], 1 - other.end) - joint;
        const Vector<2> along = endPoint(walls_[wall], 1 - end) - joint;
        const double grainSide = cross(alongOther, centre - joint);
        const double wallSide = cross(alongOther, along);
        if (grainSide * wallSide <= 0 || std::abs(wallSide) < 1e-9 * along.norm() * alongOther.norm())
        {
            return std::nullopt;
        }
        const double t = projection(wall, centre);   // concave: the segment continued beyond the joint
        return approachPoint(walls_[wall].a + t * (walls_[wall].b - walls_[wall].a), wall, centre, radius);
    }
    if (!first)
    {
        return std::nullopt;
    }
    return approachPoint(joint, wall, centre, radius);
}

}  // namespace nscd
