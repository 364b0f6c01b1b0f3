// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallFacet.hpp"
#include "overlap/disc/AngleSum.hpp"

namespace overlap
{

/// Integrals over the part of a facet within its circle, from chords and the angle of the arcs between them.
class InnerIntegrals
{
public:
    explicit InnerIntegrals(double h) : h_(h), h2_(h * h), a2_((1 - h) * (1 + h)) {}

    void chord(const Chord& x)
    {
        crossed_ = true;
        const double r0 = x.b0 > 0 ? std::sqrt(h2_ + x.x0.squaredNorm()) : 1;
        const double r1 = x.b1 > 0 ? std::sqrt(h2_ + x.x1.squaredNorm()) : 1;
        addHalfSolidAngle(halfSolidAngle_, h_, x.x0, r0, x.x1, r1, x.cross);
        cross_ += x.cross;
        moment_ += x.cross * (2 * a2_ + x.b0 + x.b1 + x.d.squaredNorm() / 3);
    }

    void outside(const Point2& x0, const Point2& x1, double c) { arcs_.add(x0.dot(x1), c); }

    void addTo(FaceParts& parts, double sign, const Point3& normal) const
    {
        const double arcs = crossed_ ? arcs_.value() : 2 * pi * arcs_.turns();
        if (!crossed_ && arcs == 0) return;

        const double omega = crossed_ ? 2 * halfSolidAngle_.value() : 0, u = 1 - h_;
        const double area = 0.5 * (cross_ + a2_ * arcs);
        parts.reached = true;
        parts.volume += sign * (omega / 3 - h_ * cross_ / 6 + arcs * u * u * (2 + h_) / 6);
        parts.patch += sign * (omega + arcs * u);
        parts.area += area;
        parts.areaVector += area * normal;
        parts.moment -= (moment_ / 16 + arcs * a2_ * a2_ / 8) * normal;
    }

private:
    double h_, h2_, a2_;
    bool crossed_ = false;
    double cross_ = 0, moment_ = 0;
    AngleSum halfSolidAngle_, arcs_;
};

}  // namespace overlap
