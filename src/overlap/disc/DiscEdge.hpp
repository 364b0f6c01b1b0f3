// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/disc/CircleEdge.hpp"

namespace overlap
{

/// Length [m] of a part of an edge and its middle [m]; that of an empty one is the disc's centre.
struct EdgePart
{
    double length = 0;
    Point2 middle = Point2::Zero();
};

/// The part of the edge p -> q that is within a disc (radius > 0); the length of that of q -> p is the same, bit for
/// bit.  Absolute error a few 1e-16 of the larger of length and radius, but where the line all but touches the circle:
/// the square root of that.
inline EdgePart edgeInDisc(const Point2& centre, double radius, const Point2& p, const Point2& q)
{
    struct
    {
        double length = 0;
        Point2 middle = Point2::Zero();
        void chord(const Chord& x)
        {
            length += x.d.norm();
            middle = 0.5 * (x.x0 + x.x1);
        }
        void outside(const Point2&, const Point2&, double) {}
    } part;

    const double scale = 1 / radius;
    const Point2 a = (p - centre) * scale, b = (q - centre) * scale;
    splitEdge(a, 1 - a.squaredNorm(), b, 1 - b.squaredNorm(), 1, part);
    return {radius * part.length, centre + radius * part.middle};
}

}  // namespace overlap
