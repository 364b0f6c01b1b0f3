// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/BoxTree.hpp"
#include "nscd/Walls.hpp"

#include <array>
#include <optional>

namespace nscd
{

/// Where two bodies are nearest to each other.
template <int D>
struct Approach
{
    Vector<D> normal;   ///< from the first to the second, of unit length
    double gap;         ///< [m], negative when they overlap
};

/// How a grain meets fixed walls.
template <int D>
class WallContact;

/// Segments.  The contact is at the nearest point of a segment; what the two segments of a joint do together:
///  - flat or convex joint: the segment above which the centre lies, or, where the joint itself is nearest, the
///    one contact with it, which the first of its segments carries;
///  - concave joint (the grain sits inside the angle): both segments, each continued beyond the joint, so that a
///    fast grain meets the second one in time.
template <>
class WallContact<2>
{
public:
    explicit WallContact(const Walls<2>& walls);

    /// Nothing when another segment speaks for this one.
    std::optional<Approach<2>> approach(int wall, const Vector<2>& centre, double radius) const;

    /// Call f(wall) for every wall nearer to x than 'reach'.
    template <class F>
    void forNear(const Vector<2>& x, double reach, F&& f) const
    {
        const Vector<2> margin = Vector<2>::Constant(reach);
        tree_.forMeeting({x - margin, x + margin},
                         [&](int wall)
                         {
                             if (distance(wall, x) < reach)
                             {
                                 f(wall);
                             }
                         });
    }

    /// Distance of a point to the nearest point of the wall [m].
    double distance(int wall, const Vector<2>& x) const;

private:
    /// Position along the wall as a fraction of its length, not yet restricted to [0, 1].
    double projection(int wall, const Vector<2>& x) const;
    Approach<2> approachPoint(const Vector<2>& point, int wall, const Vector<2>& centre, double radius) const;
    std::optional<Approach<2>> approachJoint(int wall, int end, const Vector<2>& centre, double radius) const;

    struct End
    {
        int wall;
        int end;   ///< 0: a, 1: b
    };

    Walls<2> walls_;
    BoxTree<2> tree_;
    std::vector<std::array<std::vector<End>, 2>> neighbours_;   ///< other segments at a's and b's joint
};

/// Planes.
template <>
class WallContact<3>
{
public:
    explicit WallContact(const Walls<3>& walls) : walls_(walls) {}

    std::optional<Approach<3>> approach(int wall, const Vector<3>& centre, double radius) const
    {
        const Plane& plane = std::get<Plane>(walls_[wall]);
        return Approach<3>{-plane.normal, (centre - plane.point).dot(plane.normal) - radius};
    }

    /// Call f(wall) for every wall nearer to x than 'reach'.
    template <class F>
    void forNear(const Vector<3>& x, double reach, F&& f) const
    {
        for (std::size_t wall = 0; wall < walls_.size(); ++wall)
        {
            if (distance(static_cast<int>(wall), x) < reach)
            {
                f(static_cast<int>(wall));
            }
        }
    }

    double distance(int wall, const Vector<3>& x) const
    {
        const Plane& plane = std::get<Plane>(walls_[wall]);
        return (x - plane.point).dot(plane.normal);
    }

private:
    Walls<3> walls_;
};

}  // namespace nscd
