// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/disc/DiscPolygon.hpp"

#include "overlap/disc/AngleSum.hpp"
#include "overlap/disc/CircleEdge.hpp"
#include "overlap/disc/SliverArea.hpp"

#include <algorithm>
#include <cmath>

namespace overlap
{

namespace
{

/// Line integrals along the boundary of (polygon within the unit disc).  Every term of an edge is, bit for bit, the
/// same number with the opposite sign for the cell on its other side.
class UnitDiscIntegrals
{
public:
    void chord(const Chord& x)
    {
        crossed_ = true;
        chords_ += x.cross;
        momentSum_ += (0.5 * (x.b0 + x.b1) + x.d.squaredNorm() / 6) * x.d;
    }

    void outside(const Point2& x0, const Point2& x1, double crossProduct) { arcs_.add(x0.dot(x1), crossProduct); }

    bool crossed() const { return crossed_; }
    double arcAngle() const { return arcs_.value(); }
    double area() const { return 0.5 * (chords_ + arcs_.value()); }

    /// First moment about the disc's centre.
    Point2 moment() const { return {-0.5 * momentSum_.y(), 0.5 * momentSum_.x()}; }

private:
    bool crossed_ = false;
    double chords_ = 0;
    Point2 momentSum_ = Point2::Zero();
    AngleSum arcs_;
};

}  // namespace

AreaMoment discPolygon(const Point2& centre, double radius, const Point2* vertices, std::size_t n)
{
    const double scale = 1 / radius;
    const auto local = [&](std::size_t k) -> Point2 { return (vertices[k] - centre) * scale; };

    Point2 low = local(0), high = low;
    std::size_t inside = 0;
    for (std::size_t k = 0; k < n; ++k)
    {
        const Point2 p = local(k);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        inside += p.squaredNorm() <= 1;
    }

    const AreaMoment nothing{0, centre};
    if (low.maxCoeff() >= 1 || high.minCoeff() <= -1) return nothing;
    if (inside == n) return polygon(vertices, n);

    const auto addEdges = [&](auto& integrals)
    {
        Point2 p = local(n - 1);
        double bp = 1 - p.squaredNorm();
        for (std::size_t k = 0; k < n; ++k)
        {
            const Point2 q = local(k);
            const double bq = 1 - q.squaredNorm();
            splitEdge(p, bp, q, bq, 1, integrals);
            p = q;
            bp = bq;
        }
    };
    UnitDiscIntegrals sum;
    addEdges(sum);

    if (!sum.crossed())
    {
        return sum.arcAngle() > pi ? AreaMoment{pi * radius * radius, centre} : nothing;
    }

    double area = sum.area();
    if (area < 1e-3)
    {
        SliverArea sliver;
        addEdges(sliver);
        if (sliver.isAccurate()) area = sliver.value();
    }
    if (!(area > 0)) return nothing;

    // Round-off must not put the centroid of a sliver out of disc and polygon
    Point2 centroid = sum.moment();
    for (int i = 0; i < 2; ++i)
    {
        const double quotient = std::clamp(centroid[i], -area, area) / area;
        centroid[i] = std::clamp(quotient, std::max(low[i], -1.0), std::min(high[i], 1.0));
    }
    return {area * radius * radius, centre + radius * centroid};
}

AreaMoment polygon(const Point2* vertices, std::size_t n)
{
    const Point2 origin = vertices[0];
    double twiceArea = 0;
    Point2 sixMoments = Point2::Zero(), sum = Point2::Zero();

    for (std::size_t k = 1; k + 1 < n; ++k)
    {
        const Point2 a = vertices[k] - origin, b = vertices[k + 1] - origin;
        const double c = cross(a, b);
        twiceArea += c;
        sixMoments += c * (a + b);
        sum += a;
    }

    if (twiceArea == 0)
    {
        sum += vertices[n - 1] - origin;
        return {0, origin + sum / static_cast<double>(n)};
    }
    return {0.5 * twiceArea, origin + sixMoments / (3 * twiceArea)};
}

}  // namespace overlap
