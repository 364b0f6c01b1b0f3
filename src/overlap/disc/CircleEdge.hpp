// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/Types.hpp"

#include <algorithm>
#include <cmath>

namespace overlap
{

/// The part of a polygon's edge within a circle about the origin: from x0 to x1, with d = x1 - x0, x0 x x1, and
/// b = a^2 - |x|^2 at the ends, which is zero where the circle cuts the edge.
struct Chord
{
    Point2 x0, x1, d;
    double cross, b0, b1;
};

/// Split the edge p -> q by the circle of squared radius a2 about the origin; bp and bq are a2 - |p|^2, a2 - |q|^2.
/// Calls pieces.chord(Chord) for the part within and pieces.outside(x0, x1, x0 x x1) for the others, in their order.
///
/// For the edge q -> p every number is, bit for bit, the same with the opposite sign; lengths along an edge are
/// measured from the point of its line that is nearest to the centre, which keeps the digits of edges much longer
/// than the circle.
template <class Pieces>
[[gnu::always_inline]] inline void splitEdge(const Point2& p, double bp, const Point2& q, double bq, double a2,
                                             Pieces& pieces)
{
    const Point2 d = q - p, m = 0.5 * (p + q);
    const double bm = a2 - m.squaredNorm();
    const Point2& nearest = bm >= std::max(bp, bq) ? m : bp > bq ? p : q;
    const double c = cross(nearest, d);

    if (bp >= 0 && bq >= 0)
    {
        pieces.chord(Chord{p, q, d, c, bp, bq});
        return;
    }

    const double pd = p.dot(d), qd = q.dot(d), d2 = d.squaredNorm(), reach2 = a2 * d2 - c * c;
    if (bp < 0 && bq < 0 && !(reach2 > 0 && pd < 0 && qd > 0))
    {
        pieces.outside(p, q, c);
        return;
    }

    // The line comes nearest to the centre in foot; its part in the circle is foot - before d to foot + after d
    const Point2 foot = Point2(d.y(), -d.x()) * (c / d2);
    const double reach = std::sqrt(std::max(reach2, 0.0)) / d2, toP = -pd / d2, toQ = qd / d2;
    const double before = bp < 0 ? reach : toP, after = bq < 0 ? reach : toQ;
    const double length = before + after;
    const Point2 x0 = bp < 0 ? Point2(foot - before * d) : p;
    const Point2 x1 = bq < 0 ? Point2(foot + after * d) : q;

    if (bp < 0) pieces.outside(p, x0, c * (toP - before));
    pieces.chord(Chord{x0, x1, length * d, length * c, std::max(bp, 0.0), std::max(bq, 0.0)});
    if (bq < 0) pieces.outside(x1, q, c * (toQ - after));
}

}  // namespace overlap
