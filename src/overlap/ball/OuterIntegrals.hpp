// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallFacet.hpp"
#include "overlap/disc/AngleSum.hpp"

namespace overlap
{

/// Solid angle of the part of a facet outside its circle, less what the sphere has within the circle's arcs.
class OuterIntegrals
{
public:
    explicit OuterIntegrals(double h) : h_(h), a2_((1 - h) * (1 + h)) {}

    void chord(const Chord& x)
    {
        crossed_ = true;
        cross_ += x.cross;
    }

    void outside(const Point2& x0, const Point2& x1, double c)
    {
        const double h2 = h_ * h_, r0 = std::sqrt(h2 + x0.squaredNorm()), r1 = std::sqrt(h2 + x1.squaredNorm());
        addHalfSolidAngle(halfSolidAngle_, h_, x0, r0, x1, r1, c);
        arcs_.add(x0.dot(x1), c);
    }

    void addTo(OuterParts& parts, double sign) const
    {
        double patch = 2 * halfSolidAngle_.value(), area = 0;
        if (h_ < 1)
        {
            const double arcs = crossed_ ? arcs_.value() : 2 * pi * arcs_.turns();
            patch -= arcs * (1 - h_);
            area = 0.5 * (cross_ + a2_ * arcs);
        }
        parts.patch += sign * patch;
        parts.volume += sign * (patch + h_ * area) / 3;
    }

private:
    double h_, a2_;
    bool crossed_ = false;
    double cross_ = 0;
    AngleSum halfSolidAngle_, arcs_;
};

}  // namespace overlap
