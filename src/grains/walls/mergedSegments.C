/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPieces.H"

#include <algorithm>
#include <map>

namespace
{

using nscd::Segment;
typedef nscd::Vector<2> PlanePoint;

struct ByX
{
    bool operator()(const PlanePoint& p, const PlanePoint& q) const
    {
        return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    }
};

typedef std::map<PlanePoint, std::vector<std::size_t>, ByX> Joints;

const PlanePoint& farEnd(const Segment& s, const PlanePoint& joint)
{
    return s.a == joint ? s.b : s.a;
}

// Two segments of one material and body, one the straight continuation of the other
bool isStraight(const Segment& s, const Segment& t, const PlanePoint& joint)
{
    const PlanePoint u(joint - farEnd(s, joint));
    const PlanePoint v(farEnd(t, joint) - joint);
    const double cross = u.x()*v.y() - u.y()*v.x();

    // Vertices of a mesh are written with a finite number of digits
    return
        s.material == t.material
     && s.body == t.body
     && u.dot(v) > 0
     && std::abs(cross) < 1e-9*u.norm()*v.norm();
}

// The end of the straight line that begins with segment s at 'from'
PlanePoint lineEnd
(
    const Foam::wallPieceList<2>& segments,
    const Joints& joints,
    std::size_t s,
    const PlanePoint& from,
    std::vector<bool>& used
)
{
    PlanePoint end = farEnd(segments[s], from);
    while (true)
    {
        used[s] = true;
        const std::vector<std::size_t>& here = joints.at(end);
        if (here.size() != 2)
        {
            return end;
        }
        const std::size_t next = here[here[0] == s];
        if (used[next] || !isStraight(segments[s], segments[next], end))
        {
            return end;
        }
        end = farEnd(segments[next], end);
        s = next;
    }
}

}


nscd::Walls<2> Foam::mergedSegments(const wallPieceList<2>& segments)
{
    nscd::Walls<2> sorted(segments);
    for (Segment& s : sorted)
    {
        if (ByX()(s.b, s.a))
        {
            std::swap(s.a, s.b);
        }
    }
    std::sort
    (
        sorted.begin(), sorted.end(),
        [](const Segment& s, const Segment& t)
        {
            return ByX()(s.a, t.a) || (s.a == t.a && ByX()(s.b, t.b));
        }
    );

    Joints joints;
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
        joints[sorted[i].a].push_back(i);
        joints[sorted[i].b].push_back(i);
    }

    nscd::Walls<2> merged;
    std::vector<bool> used(sorted.size(), false);
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
        if (!used[i])
        {
            const Segment& s = sorted[i];
            const PlanePoint forth = lineEnd(sorted, joints, i, s.a, used);
            const PlanePoint back = lineEnd(sorted, joints, i, s.b, used);
            merged.push_back({back, forth, s.material, s.body});
        }
    }
    return merged;
}
