// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/DiscPolygon.hpp"

#include <algorithm>
#include <cmath>

namespace overlap
{

namespace
{

constexpr double pi = 3.14159265358979323846;

double cross(const Point2& a, const Point2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Sum of signed angles, each in (-pi, pi): one complex product and the number of times its argument passed pi.
class AngleSum
{
public:
    /// Add the angle whose cosine and sine are in the ratio cosine : sine.
    void add(double cosine, double sine)
    {
        const double re = re_ * cosine - im_ * sine;
        const double im = re_ * sine + im_ * cosine;
        if (im_ >= 0 && sine > 0 && im < 0) ++turns_;
        if (im_ < 0 && sine < 0 && im >= 0) --turns_;
        re_ = re;
        im_ = im;

        if (std::abs(re_) + std::abs(im_) > 1e100)
        {
            re_ *= 1e-100;
            im_ *= 1e-100;
        }
    }

    double value() const { return std::atan2(im_, re_) + 2 * pi * turns_; }

private:
    double re_ = 1, im_ = 0;
    int turns_ = 0;
};

/// Line integrals along the boundary of (polygon within the unit disc).
///
/// Every term of an edge is, bit for bit, the same number with the opposite sign for the cell on its other side;
/// lengths along an edge are measured from the point of its line that is nearest to the centre, which keeps the
/// digits of cells much larger than the disc.
class UnitDiscIntegrals
{
public:
    /// Add the edge p -> q; bp and bq are 1 - |p|^2 and 1 - |q|^2.
    void addEdge(const Point2& p, double bp, const Point2& q, double bq)
    {
        const Point2 d = q - p, m = 0.5 * (p + q);
        const double bm = 1 - m.squaredNorm();
        const Point2& nearest = bm >= std::max(bp, bq) ? m : bp > bq ? p : q;
        const double c = cross(nearest, d);

        if (bp >= 0 && bq >= 0)
        {
            addChord(d, c, bp, bq);
            return;
        }

        const double pd = p.dot(d), qd = q.dot(d), d2 = d.squaredNorm(), reach2 = d2 - c * c;
        if (bp < 0 && bq < 0 && !(reach2 > 0 && pd < 0 && qd > 0))
        {
            arcs_.add(p.dot(q), c);
            return;
        }

        // The line comes nearest to the centre in foot; its part in the disc is foot - before d to foot + after d
        const Point2 foot = Point2(d.y(), -d.x()) * (c / d2);
        const double reach = std::sqrt(std::max(reach2, 0.0)) / d2, toP = -pd / d2, toQ = qd / d2;
        const double before = bp < 0 ? reach : toP, after = bq < 0 ? reach : toQ;
        if (bp < 0) arcs_.add(p.dot(foot - before * d), c * (toP - before));
        if (bq < 0) arcs_.add(q.dot(foot + after * d), c * (toQ - after));
        const double length = before + after;
        addChord(length * d, length * c, std::max(bp, 0.0), std::max(bq, 0.0));
    }

    bool crossed() const { return crossed_; }
    double arcAngle() const { return arcs_.value(); }
    double area() const { return 0.5 * (chords_ + arcs_.value()); }

    /// First moment about the disc's centre.
    Point2 moment() const { return {-0.5 * momentSum_.y(), 0.5 * momentSum_.x()}; }

private:
    /// A piece of an edge inside the disc: its vector, the cross product of its ends x, and 1 - |x|^2 there.
    void addChord(const Point2& d, double crossProduct, double b0, double b1)
    {
        crossed_ = true;
        chords_ += crossProduct;
        momentSum_ += (0.5 * (b0 + b1) + d.squaredNorm() / 6) * d;
    }

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

    UnitDiscIntegrals sum;
    Point2 p = local(n - 1);
    double bp = 1 - p.squaredNorm();
    for (std::size_t k = 0; k < n; ++k)
    {
        const Point2 q = local(k);
        const double bq = 1 - q.squaredNorm();
        sum.addEdge(p, bp, q, bq);
        p = q;
        bp = bq;
    }

    if (!sum.crossed())
    {
        return sum.arcAngle() > pi ? AreaMoment{pi * radius * radius, centre} : nothing;
    }

    const double area = sum.area();
    if (!(area > 0)) return nothing;

    // The centroid of a sliver is noise in the last digits of the area: keep it within disc and polygon.
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
