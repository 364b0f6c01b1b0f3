// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Ball and polyhedron by another way, in extended precision: the polyhedron is a signed sum of cones from the ball's
// centre to the triangles of its faces.  In a cone's direction the ball reaches to min(1, distance of the face), so
// that the radial integrals are elementary; the one over the angle about the foot of the centre in the face's plane is
// done by Gauss's rule, in the variable u with y = D sinh(u) along an edge at distance D from the foot, in which the
// integrands are analytic in a strip of width pi.

#include "overlap/mesh/Polyhedron.hpp"

#include <quadmath.h>

#include <array>
#include <cmath>
#include <vector>

namespace overlap::oracle
{

__extension__ typedef __float128 Quad;

inline long double root(long double x)
{
    return std::sqrt(x);
}
inline long double exponential(long double x)
{
    return std::exp(x);
}
inline long double areaSinh(long double x)
{
    return std::asinh(x);
}
inline long double angle(long double y, long double x)
{
    return std::atan2(y, x);
}
inline Quad root(Quad x)
{
    return sqrtq(x);
}
inline Quad exponential(Quad x)
{
    return expq(x);
}
inline Quad areaSinh(Quad x)
{
    return asinhq(x);
}
inline Quad angle(Quad y, Quad x)
{
    return atan2q(y, x);
}

template <class Real>
struct Vector
{
    Real x, y, z;

    Vector operator+(const Vector& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vector operator-(const Vector& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vector operator*(Real s) const { return {x * s, y * s, z * s}; }
    Real dot(const Vector& b) const { return x * b.x + y * b.y + z * b.z; }
    Vector cross(const Vector& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
    Real norm() const { return root(dot(*this)); }
    Point3 toDouble() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};

/// Points and weights of Gauss and Legendre on [-1, 1].
template <class Real, int n>
const std::array<std::pair<Real, Real>, n>& gauss()
{
    static const auto rule = []
    {
        std::array<std::pair<Real, Real>, n> points;
        for (int k = 0; k < n; ++k)
        {
            Real x = std::cos(3.14159265358979 * (k + 0.75) / (n + 0.5)), slope = 1;
            for (int iteration = 0; iteration < 8; ++iteration)
            {
                Real before = 1, value = x;
                for (int i = 2; i <= n; ++i)
                {
                    const Real next = ((2 * i - 1) * x * value - (i - 1) * before) / i;
                    before = value;
                    value = next;
                }
                slope = n * (x * value - before) / (x * x - 1);
                x -= value / slope;
            }
            points[k] = {x, 2 / ((1 - x * x) * slope * slope)};
        }
        return points;
    }();
    return rule;
}

/// In units of the ball's radius, about its centre.
template <class Real>
struct Parts
{
    Real volume = 0, patch = 0, area = 0;
    Vector<Real> moment{0, 0, 0};
};

/// The cone from the centre to a plane polygon.
template <class Real>
class Cone
{
public:
    static void add(const std::vector<Vector<Real>>& loop, Parts<Real>& sum)
    {
        Vector<Real> twiceArea{0, 0, 0};
        for (std::size_t k = 1; k + 1 < loop.size(); ++k)
        {
            twiceArea = twiceArea + (loop[k] - loop[0]).cross(loop[k + 1] - loop[0]);
        }
        const Real norm = twiceArea.norm();
        if (!(norm > 0)) return;
        Cone cone(twiceArea * (1 / norm), loop[0]);
        for (std::size_t k = 0; k < loop.size(); ++k) cone.addEdge(loop[k], loop[(k + 1) % loop.size()], sum);
    }

private:
    Cone(const Vector<Real>& normal, const Vector<Real>& vertex)
        : normal_(normal), height_(normal.dot(vertex)), h_(height_ < 0 ? -height_ : height_)
    {
        const Real a2 = (1 - h_) * (1 + h_);
        a_ = a2 > 0 ? root(a2) : Real(0);
    }

    void addEdge(const Vector<Real>& p, const Vector<Real>& q, Parts<Real>& sum)
    {
        const Real length = (q - p).norm();
        if (!(length > 0)) return;
        along_ = (q - p) * (1 / length);
        outward_ = along_.cross(normal_);
        distance_ = outward_.dot(p);
        if (distance_ == 0) return;

        const Real ends[] = {along_.dot(p), along_.dot(q)};
        const Real half2 = a_ * a_ - distance_ * distance_;
        Real from = ends[0];
        if (half2 > 0)
        {
            const Real half = root(half2);
            for (const Real split : {-half, half})
            {
                if (split > from && split < ends[1])
                {
                    addPiece(from, split, sum);
                    from = split;
                }
            }
        }
        addPiece(from, ends[1], sum);
    }

    void addPiece(Real y0, Real y1, Parts<Real>& sum) const
    {
        constexpr int n = sizeof(Quad) == sizeof(Real) && Real(1) + Real(1e-25) > Real(1) ? 32 : 16;
        const Real size = distance_ < 0 ? -distance_ : distance_;
        const Real u0 = areaSinh(y0 / size), u1 = areaSinh(y1 / size);
        const int steps = 1 + static_cast<int>((u1 - u0) / Real(1.5));
        for (int step = 0; step < steps; ++step)
        {
            const Real half = (u1 - u0) / (2 * steps), middle = u0 + (2 * step + 1) * half;
            for (const auto& [x, weight] : gauss<Real, n>())
            {
                const Real e = exponential(middle + half * x), cosh = (e + 1 / e) / 2;
                addPoint(size * (e - 1 / e) / 2, half * weight / cosh * (distance_ < 0 ? -1 : 1), sum);
            }
        }
    }

    /// The ray from the foot to the point y of the edge, over an angle of the given size.
    void addPoint(Real y, Real dPhi, Parts<Real>& sum) const
    {
        const Real rho2 = distance_ * distance_ + y * y, rho = root(rho2), r2 = h_ * h_ + rho2, r = root(r2);
        const Real a2 = a_ * a_, m = h_ > 1 ? h_ : Real(1);
        const bool within = r2 <= 1;
        const Real volume = within ? h_ * rho2 / 6 : h_ * a2 / 6 + h_ / 3 * (1 / m - 1 / r);
        const Real patch = within ? Real(0) : h_ * (1 / m - 1 / r);
        const Real across = within ? h_ * rho2 / 8 : h_ * a2 / 8 + h_ / 8 * (1 / (m * m) - 1 / r2);
        const Real inPlane =
            within ? h_ * rho2 * rho / 12
                   : h_ * a2 * a_ / 12 + (angle(rho, h_) - h_ * rho / r2 - angle(a_, h_) + h_ * a_ / (m * m)) / 8;

        const Real sign = height_ < 0 ? -1 : 1;
        sum.volume += sign * dPhi * volume;
        sum.patch += sign * dPhi * patch;
        sum.area += dPhi * (within ? rho2 : a2) / 2;
        const Vector<Real> direction = (outward_ * distance_ + along_ * y) * (1 / rho);
        sum.moment = sum.moment + (normal_ * (height_ * across) + direction * inPlane) * (sign * dPhi);
    }

    Vector<Real> normal_;
    Real height_, h_, a_;
    Vector<Real> along_, outward_;
    Real distance_;
};

/// Ball and polyhedron; fans: faces are fans of triangles about the average of their vertices, otherwise plane.
template <class Real>
Parts<Real> ballPolyhedron(const Point3& centre, double radius, const std::vector<Point3>& vertices,
                           const std::vector<std::vector<int>>& faces, bool fans)
{
    const auto local = [&](const Point3& x) -> Vector<Real>
    {
        const Vector<Real> d{Real(x.x()) - Real(centre.x()), Real(x.y()) - Real(centre.y()),
                             Real(x.z()) - Real(centre.z())};
        return d * (1 / Real(radius));
    };

    Parts<Real> sum;
    for (const std::vector<int>& face : faces)
    {
        std::vector<Vector<Real>> loop;
        Point3 average = Point3::Zero();
        for (const int k : face)
        {
            loop.push_back(local(vertices[k]));
            average += vertices[k];
        }
        if (!fans)
        {
            Cone<Real>::add(loop, sum);
            continue;
        }
        const Vector<Real> hub = local(average / static_cast<double>(face.size()));
        for (std::size_t k = 0; k < loop.size(); ++k) Cone<Real>::add({loop[k], loop[(k + 1) % loop.size()], hub}, sum);
    }
    return sum;
}

}  // namespace overlap::oracle
