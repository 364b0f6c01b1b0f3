// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallFace.hpp"
#include "overlap/disc/AngleSum.hpp"
#include "overlap/disc/CircleEdge.hpp"

#include <cmath>

namespace overlap
{

/// A facet seen from the ball: distance h of its plane, foot of the centre, and the circle in which they meet.
struct BallFacet
{
    BallFacet(const UnitBall& ball, const Facet& facet)
        : scale(ball.scale), signedHeight(height(ball, facet)), h(std::abs(signedHeight)), a2((1 - h) * (1 + h)),
          foot(facet.inFrame(ball.centre)), low((facet.low - foot) * scale), high((facet.high - foot) * scale)
    {
    }

    double sign() const { return signedHeight < 0 ? -1 : 1; }

    /// Whether the bounds of the facet meet a square of half side a about the foot.
    bool meets(double a) const { return low.x() < a && low.y() < a && high.x() > -a && high.y() > -a; }

    /// Hand the edges to pieces, split by the circle.
    template <class Pieces>
    void forEdges(const Point2* vertices, std::size_t n, Pieces& pieces) const
    {
        const auto local = [&](std::size_t k) -> Point2 { return (vertices[k] - foot) * scale; };
        Point2 p = local(n - 1);
        double bp = a2 - p.squaredNorm();
        for (std::size_t k = 0; k < n; ++k)
        {
            const Point2 q = local(k);
            const double bq = a2 - q.squaredNorm();
            splitEdge(p, bp, q, bq, a2, pieces);
            p = q;
            bp = bq;
        }
    }

    double scale, signedHeight, h, a2;
    Point2 foot, low, high;
};

/// Half the solid angle of the triangle (foot, x0, x1) at height h, added to a sum.
inline void addHalfSolidAngle(AngleSum& sum, double h, const Point2& x0, double r0, const Point2& x1, double r1,
                              double c)
{
    sum.add((r0 + h) * (r1 + h) + x0.dot(x1), c);
}

}  // namespace overlap
