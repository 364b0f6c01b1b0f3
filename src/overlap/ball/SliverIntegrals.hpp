// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallFacet.hpp"
#include "overlap/base/GaussPoints.hpp"
#include "overlap/disc/AngleSum.hpp"

namespace overlap
{

/// What one chord, or the full turn of a circle, adds to the sums of a facet.
struct Sums
{
    double volume = 0, patch = 0, area = 0, moment = 0;

    void add(double factor, const Sums& x)
    {
        volume += factor * x.volume;
        patch += factor * x.patch;
        area += factor * x.area;
        moment += factor * x.moment;
    }
};

/// The part of a facet within its circle is a circle sector for every angle that the boundary turns through, less
/// what lies between chord and circle.  That is a smooth integral of one sign along a chord short against its
/// distance from the foot; longer chords have angle and triangle apart.
class SliverIntegrals
{
public:
    explicit SliverIntegrals(double h) : h_(h), a2_((1 - h) * (1 + h))
    {
        const double u = 1 - h;
        perAngle_ = {u * u * (2 + h) / 6, u, a2_ / 2, a2_ * a2_ / 4};
    }

    void chord(const Chord& x)
    {
        crossed_ = true;
        const double length2 = x.d.squaredNorm();
        const double nearest2 = a2_ - std::max(x.b0, x.b1) - 0.25 * length2;
        const double cosine = x.x0.dot(x.x1);
        if (length2 < 0.25 * nearest2)
        {
            const double ratio = length2 / nearest2;
            if (ratio < 1e-4)
                addShort<5>(x, length2);
            else if (ratio < 1.6e-3)
                addShort<6>(x, length2);
            else if (ratio < 0.04)
                addShort<8>(x, length2);
            else
                addShort<12>(x, length2);
            rest_.add(cosine, x.cross);
        }
        else
        {
            addLong(x, length2, cosine);
            longAngles_ += std::atan2(x.cross, cosine);
        }
    }

    void outside(const Point2& x0, const Point2& x1, double c) { rest_.add(x0.dot(x1), c); }

    void addTo(FaceParts& parts, double sign, const Point3& normal)
    {
        if (!crossed_ && rest_.turns() == 0) return;

        // Without a chord that ends in the foot all angles together are a number of turns
        const double all = rest_.value() + longAngles_, turns = 2 * pi * std::round(all / (2 * pi));
        sums_.add(std::abs(all - turns) < 1e-6 ? turns - longAngles_ : rest_.value(), perAngle_);

        parts.reached = true;
        parts.volume += sign * sums_.volume;
        parts.patch += sign * sums_.patch;
        parts.area += sums_.area;
        parts.areaVector += sums_.area * normal;
        parts.moment -= 0.5 * sums_.moment * normal;
    }

private:
    template <int n>
    void addShort(const Chord& x, double length2)
    {
        using Points = GaussPoints<n>;
        double volume[n], patch[n], area[n];
        for (int k = 0; k < n; ++k)
        {
            const double t = Points::t[k];
            const double b = x.b0 * (1 - t) + x.b1 * t + t * (1 - t) * length2;
            const double r = std::sqrt(1 - b), rho2 = a2_ - b;
            const double w = b * Points::weight[k] / (r * (1 + r) * rho2);
            volume[k] = w * w * (2 + r) * r * rho2 / Points::weight[k];
            patch[k] = w;
            area[k] = w * r * (1 + r);
        }
        Sums between;
        for (int k = 0; k < n; ++k)
        {
            const double t = Points::t[k];
            between.volume += volume[k];
            between.patch += patch[k];
            between.area += area[k];
            between.moment += area[k] * (x.b0 * (1 - t) + x.b1 * t + t * (1 - t) * length2);
        }
        sums_.volume -= x.cross * h_ / 6 * between.volume;
        sums_.patch -= x.cross * h_ * between.patch;
        sums_.area -= x.cross / 2 * between.area;
        sums_.moment -= x.cross / 4 * between.moment;
    }

    void addLong(const Chord& x, double length2, double cosine)
    {
        const double h2 = h_ * h_;
        const double r0 = x.b0 > 0 ? std::sqrt(h2 + x.x0.squaredNorm()) : 1;
        const double r1 = x.b1 > 0 ? std::sqrt(h2 + x.x1.squaredNorm()) : 1;
        const double omega = 2 * std::atan2(x.cross, (r0 + h_) * (r1 + h_) + cosine);
        sums_.patch += omega;
        sums_.area += x.cross / 2;
        sums_.moment += x.cross / 8 * (2 * a2_ + x.b0 + x.b1 + length2 / 3);
        sums_.volume += h_ > 0.9 ? nearlyTangent(x, length2) : omega / 3 - h_ * x.cross / 6;
    }

    /// Omega/3 - h cross/6 where the two nearly cancel.
    double nearlyTangent(const Chord& x, double length2) const
    {
        const double v = 1 - h_;
        double sum = 0;
        for (int k = 0; k < 10; ++k)
        {
            const double t = GaussPoints<10>::t[k];
            const double b = x.b0 * (1 - t) + x.b1 * t + t * (1 - t) * length2;
            const double r = std::sqrt(1 - b), u = b / (1 + r);
            const double difference = (u + v) * (3 + u * v) - (u + v) * (u + v) - 2 * u * v;
            sum += GaussPoints<10>::weight[k] * difference / (r * (r + h_));
        }
        return x.cross / 6 * sum;
    }

    double h_, a2_;
    bool crossed_ = false;
    double longAngles_ = 0;
    AngleSum rest_;
    Sums sums_, perAngle_;
};

}  // namespace overlap
