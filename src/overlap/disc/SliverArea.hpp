// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/GaussPoints.hpp"
#include "overlap/disc/CircleEdge.hpp"

namespace overlap
{

/// Area of the unit disc within a polygon that is much smaller than it and does not hold its centre, from its chords
/// alone: each adds what lies between it and the circle, seen from the centre (doc/theory, eq. 1.12).  Nothing
/// cancels but what chords of opposite sign enclose.
class SliverArea
{
public:
    void chord(const Chord& x)
    {
        const double length2 = x.d.squaredNorm();
        isShort_ = isShort_ && length2 < 0.25 && std::max(x.b0, x.b1) + 0.25 * length2 < 0.5;
        if (length2 < 1e-3)
            add<6>(x, length2);
        else
            add<12>(x, length2);
    }

    void outside(const Point2&, const Point2&, double) {}

    double value() const { return area_; }

    /// Are the chords so short, and so close to the circle, that the quadrature is exact to 1e-14?
    bool isAccurate() const { return isShort_; }

private:
    template <int n>
    void add(const Chord& x, double length2)
    {
        double sum = 0;
        for (int k = 0; k < n; ++k)
        {
            const double t = GaussPoints<n>::t[k];
            const double b = x.b0 * (1 - t) + x.b1 * t + t * (1 - t) * length2;
            sum += GaussPoints<n>::weight[k] * b / (1 - b);
        }
        area_ -= 0.5 * x.cross * sum;
    }

    double area_ = 0;
    bool isShort_ = true;
};

}  // namespace overlap
