// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/shape/UnionMoments.hpp"

#include "nscd/base/Pi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nscd
{

namespace
{

/// Nodes and weights of Gauss-Legendre's rule on (0, 1).
struct GaussRule
{
    static constexpr int size = 20;
    std::array<double, size> node, weight;

    GaussRule()
    {
        for (int i = 0; i < size; ++i)
        {
            double x = std::cos(pi * (i + 0.75) / (size + 0.5));
            double derivative = 0;
            for (int newton = 0; newton < 6; ++newton)
            {
                double p = x, before = 1;  // Legendre polynomials of degree 1 and 0
                for (int k = 2; k <= size; ++k)
                {
                    before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
                }
                derivative = size * (x * p - before) / (x * x - 1);
                x -= p / derivative;
            }
            node[i] = (1 - x) / 2;
            weight[i] = 1 / ((1 - x * x) * derivative * derivative);
        }
    }
};

/// The circle in which two spheres meet; a negative radius if they do not.
struct Circle
{
    Vector<3> centre, normal;
    double radius = -1;

    Circle(const Vector<3>& a, double ra, const Vector<3>& b, double rb) : centre(a), normal(b - a)
    {
        const double distance = normal.norm();
        if (distance > std::abs(ra - rb) && distance < ra + rb)
        {
            normal /= distance;
            const double t = (distance + (ra - rb) * (ra + rb) / distance) / 2;
            centre += t * normal;
            radius = std::sqrt(std::max(0.0, (ra - t) * (ra + t)));
        }
    }
};

/// Heights at which the horizontal cross-section of the spheres' surfaces changes its topology: tops and bottoms of the
/// spheres and of the circles in which two of them meet, and points in which three of them meet.
std::vector<double> breakPoints(const Vectors<3>& centres, const std::vector<double>& radii)
{
    std::vector<double> heights;
    const auto add = [&heights](double middle, double half) {
        heights.insert(heights.end(), {middle - half, middle + half});
    };
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        add(centres[i].z(), radii[i]);
        for (std::size_t j = 0; j < i; ++j)
        {
            const Circle circle(centres[i], radii[i], centres[j], radii[j]);
            if (circle.radius < 0)
            {
                continue;
            }
            add(circle.centre.z(), circle.radius * circle.normal.head<2>().norm());
            for (std::size_t k = 0; k < j; ++k)
            {
                // In the circle's plane: the line on which sphere k has the same power as the circle
                const Vector<3> d = centres[k] - circle.centre;
                const Vector<3> inPlane = d - d.dot(circle.normal) * circle.normal;
                const double distance = inPlane.norm();
                const double power = (d.squaredNorm() + circle.radius * circle.radius - radii[k] * radii[k]) / 2;
                if (std::abs(power) < circle.radius * distance)
                {
                    const Vector<3> u = inPlane / distance;
                    const double t = power / distance;
                    const double half = std::sqrt((circle.radius - t) * (circle.radius + t));
                    add(circle.centre.z() + t * u.z(), half * circle.normal.cross(u).z());
                }
            }
        }
    }
    std::sort(heights.begin(), heights.end());
    return heights;
}

/// Cross-section at a height, times 'weight', added to the moments.
void addSlice(const Vectors<3>& centres, const std::vector<double>& radii, double z, double weight, Moments<3>& moments)
{
    Vectors<2> discs;
    std::vector<double> discRadii;
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        const double h = z - centres[i].z();
        const double square = (radii[i] - h) * (radii[i] + h);
        if (square > 0)
        {
            discs.push_back(centres[i].head<2>());
            discRadii.push_back(std::sqrt(square));
        }
    }
    const Moments<2> slice = unionMoments<2>(discs, discRadii);
    moments.volume += weight * slice.volume;
    moments.first.head<2>() += weight * slice.first;
    moments.first.z() += weight * z * slice.volume;
    moments.second.topLeftCorner<2, 2>() += weight * slice.second;
    moments.second.topRightCorner<2, 1>() += weight * z * slice.first;
    moments.second.bottomLeftCorner<1, 2>() += weight * z * slice.first.transpose();
    moments.second(2, 2) += weight * z * z * slice.volume;
}

}  // namespace

template <>
Moments<3> unionMoments<3>(const Vectors<3>& centres, const std::vector<double>& radii)
{
    static const GaussRule gauss;
    Moments<3> moments;
    const std::vector<double> heights = breakPoints(centres, radii);
    for (std::size_t h = 1; h < heights.size(); ++h)
    {
        // Half powers of the distance to either end become whole powers of s in z = middle - half cos(pi s)
        const double middle = (heights[h] + heights[h - 1]) / 2, half = (heights[h] - heights[h - 1]) / 2;
        for (int n = 0; half > 0 && n < GaussRule::size; ++n)
        {
            const double angle = pi * gauss.node[n];
            addSlice(centres, radii, middle - half * std::cos(angle), gauss.weight[n] * half * pi * std::sin(angle),
                     moments);
        }
    }
    return moments;
}

}  // namespace nscd
