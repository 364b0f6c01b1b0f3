// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/shape/UnionMoments.hpp"

#include "nscd/base/Pi.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace nscd
{

namespace
{

using Complex = std::complex<double>;

/// A disc of the complex plane.
struct Disc
{
    Complex centre;
    double radius;
};

/// An arc of a circle, from one angle to a larger one.
struct Arc
{
    double from, to;
};

/// Integrals of 1, z, z^2 and |z|^2.
struct PlaneMoments
{
    double one = 0, square = 0;
    Complex z = 0, zz = 0;

    /// What an arc of the boundary contributes: a homogeneous f of degree k has the integral of
    /// f (x dy - y dx)/(k + 2) along the boundary, and on a circle z = c + r u, u = exp(i theta).
    void add(const Disc& disc, const Arc& arc)
    {
        const Complex c = disc.centre, cBar = std::conj(c);
        const double r = disc.radius;
        const auto power = [&arc](int k)  // integral of u^k
        { return (std::polar(1.0, k * arc.to) - std::polar(1.0, k * arc.from)) / Complex(0, k); };
        const double u0 = arc.to - arc.from;
        const Complex u1 = power(1), u2 = power(2), u3 = power(3);

        const double w = r * (r * u0 + (cBar * u1).real());            // of x dy - y dx
        const Complex wu = r * (r * u1 + 0.5 * (cBar * u2 + c * u0));  // of u (x dy - y dx)
        const Complex wuu = r * (r * u2 + 0.5 * (cBar * u3 + c * u1));
        one += w / 2;
        z += (c * w + r * wu) / 3.0;
        zz += (c * c * w + 2.0 * c * r * wu + r * r * wuu) / 4.0;
        square += ((std::norm(c) + r * r) * w + 2 * r * (cBar * wu).real()) / 4;
    }
};

/// The part of circle i that lies within disc j; of equal discs the first covers the second.
Arc coveredArc(const std::vector<Disc>& discs, std::size_t i, std::size_t j)
{
    const Complex d = discs[j].centre - discs[i].centre;
    const double distance = std::abs(d), r = discs[i].radius, other = discs[j].radius;
    if (distance == 0 && r == other)
    {
        return {0, j < i ? 2 * pi : 0};
    }
    if (distance <= other - r)
    {
        return {0, 2 * pi};
    }
    if (distance >= r + other || distance <= r - other)
    {
        return {0, 0};
    }
    const double cosine = (distance + (r - other) * (r + other) / distance) / (2 * r);
    const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
    return {std::arg(d) - half, std::arg(d) + half};
}

PlaneMoments momentsOf(const std::vector<Disc>& discs)
{
    PlaneMoments moments;
    std::vector<Arc> covered;
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
        covered.clear();
        for (std::size_t j = 0; j < discs.size(); ++j)
        {
            const Arc arc = j == i ? Arc{0, 0} : coveredArc(discs, i, j);
            const double shift = arc.from < 0 ? 2 * pi : 0;
            const double from = arc.from + shift, to = arc.to + shift;
            covered.push_back({from, std::min(to, 2 * pi)});
            covered.push_back({0, std::max(0.0, to - 2 * pi)});
        }
        std::sort(covered.begin(), covered.end(), [](const Arc& a, const Arc& b) { return a.from < b.from; });
        covered.push_back({2 * pi, 2 * pi});

        double reached = 0;
        for (const Arc& arc : covered)
        {
            if (arc.from > reached)
            {
                moments.add(discs[i], {reached, arc.from});
            }
            reached = std::max(reached, arc.to);
        }
    }
    return moments;
}

}  // namespace

template <>
Moments<2> unionMoments<2>(const Vectors<2>& centres, const std::vector<double>& radii)
{
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        discs.push_back({{centres[i].x(), centres[i].y()}, radii[i]});
    }
    const PlaneMoments plane = momentsOf(discs);
    Moments<2> moments;
    moments.volume = plane.one;
    moments.first = {plane.z.real(), plane.z.imag()};
    moments.second << plane.square + plane.zz.real(), plane.zz.imag(), plane.zz.imag(), plane.square - plane.zz.real();
    moments.second /= 2;
    return moments;
}

}  // namespace nscd
