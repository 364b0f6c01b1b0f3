// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random pairs against two methods that share nothing with the library's.

#include "Shapes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace overlap;

namespace
{

using Real = long double;
using Point = Eigen::Matrix<Real, 2, 1>;

struct Reference
{
    Real area = 0;
    Point moment = Point::Zero();
};

/// The unit disc within the triangle (centre, p, q), signed: at most three pieces, sectors and triangles.
Reference discTriangle(const Point& p, const Point& q)
{
    const auto cross = [](const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); };

    Reference sum;
    const auto triangle = [&](const Point& a, const Point& b)
    {
        sum.area += cross(a, b) / 2;
        sum.moment += cross(a, b) / 6 * (a + b);
    };
    const auto sector = [&](const Point& a, const Point& b)
    {
        sum.area += std::atan2(cross(a, b), a.dot(b)) / 2;
        const Point ea = a.normalized(), eb = b.normalized();
        sum.moment += Point(eb.y() - ea.y(), ea.x() - eb.x()) / 3;
    };

    const Point d = q - p;
    const Real a = d.squaredNorm(), b = p.dot(d), c = p.squaredNorm() - 1, discriminant = b * b - a * c;
    if (discriminant <= 0)
    {
        sector(p, q);
        return sum;
    }
    const Real t0 = std::clamp<Real>((-b - std::sqrt(discriminant)) / a, 0, 1);
    const Real t1 = std::clamp<Real>((-b + std::sqrt(discriminant)) / a, 0, 1);
    const Point x0 = p + t0 * d, x1 = p + t1 * d;
    if (t0 > 0) sector(p, x0);
    if (t1 > t0) triangle(x0, x1);
    if (t1 < 1) sector(x1, q);
    return sum;
}

Reference bySignedTriangles(const Point2& centre, double radius, const Polygon& cell)
{
    Reference sum;
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
        const Point p = (cell[k].cast<Real>() - centre.cast<Real>()) / radius;
        const Point q = (cell[(k + 1) % cell.size()].cast<Real>() - centre.cast<Real>()) / radius;
        const Reference part = discTriangle(p, q);
        sum.area += part.area;
        sum.moment += part.moment;
    }
    return sum;
}

/// Length of the vertical line at x within unit disc and polygon.
double lineWithin(const Polygon& cell, double x)
{
    std::vector<double> crossings;
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
        const Point2 p = cell[k], q = cell[(k + 1) % cell.size()];
        if ((p.x() <= x) != (q.x() <= x)) crossings.push_back(p.y() + (x - p.x()) / (q.x() - p.x()) * (q.y() - p.y()));
    }
    std::sort(crossings.begin(), crossings.end());

    const double half = std::sqrt(std::max(0.0, 1 - x * x));
    double length = 0;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
    {
        length += std::max(0.0, std::min(crossings[k + 1], half) - std::max(crossings[k], -half));
    }
    return length;
}

/// Area by quadrature over vertical strips that end where an edge or the circle begins, ends or crosses the other:
/// within a strip the integrand is smooth in phi, x = -cos(phi).
double byStrips(const Polygon& cell)
{
    std::vector<double> ends = {0, pi};
    const auto addEnd = [&](double x)
    {
        if (std::abs(x) < 1) ends.push_back(std::acos(-x));
    };
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
        const Point2 p = cell[k], d = cell[(k + 1) % cell.size()] - p;
        addEnd(p.x());
        const double root = p.dot(d) * p.dot(d) - d.squaredNorm() * (p.squaredNorm() - 1);
        if (root < 0) continue;
        addEnd(p.x() + d.x() * (-p.dot(d) - std::sqrt(root)) / d.squaredNorm());
        addEnd(p.x() + d.x() * (-p.dot(d) + std::sqrt(root)) / d.squaredNorm());
    }
    std::sort(ends.begin(), ends.end());

    // Gauss-Legendre, 4 points on each of 8 parts
    const double nodes[] = {0.8611363115940526, 0.3399810435848563},
                 weights[] = {0.3478548451374538, 0.6521451548625461};
    const int parts = 8;
    double area = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    {
        const double half = 0.5 * (ends[k + 1] - ends[k]) / parts;
        for (int part = 0; part < parts; ++part)
        {
            const double middle = ends[k] + (2 * part + 1) * half;
            for (int i = 0; i < 4; ++i)
            {
                const double phi = middle + (i < 2 ? 1 : -1) * half * nodes[i % 2];
                area += half * weights[i % 2] * std::sin(phi) * lineWithin(cell, -std::cos(phi));
            }
        }
    }
    return area;
}

/// Star-shaped, usually not convex polygon about a random point.
Polygon randomPolygon(std::mt19937& random, double size)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const int n = 3 + static_cast<int>(6 * unit(random));
    const double reach = size + 1, turn = 2 * pi * unit(random);
    const Point2 middle(reach * (2 * unit(random) - 1), reach * (2 * unit(random) - 1));

    Polygon cell;
    for (int k = 0; k < n; ++k)
    {
        const double angle = turn + 2 * pi * (k + 0.45 * unit(random)) / n;
        cell.push_back(middle + rotated({size * (0.3 + 0.7 * unit(random)), 0}, angle));
    }
    return cell;
}

}  // namespace

TEST(RandomPairs, AgreeWithSignedTrianglesInExtendedPrecision)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> logSize(std::log(1. / 15), std::log(60.));
    double worstArea = 0, worstMoment = 0;
    int cut = 0;

    for (int pair = 0; pair < 100000; ++pair)
    {
        const Polygon cell = randomPolygon(random, std::exp(logSize(random)));
        const AreaMoment a = unitDisc(cell);
        const Reference exact = bySignedTriangles({0, 0}, 1, cell);

        cut += a.area > 0 && a.area < pi && a.area != polygon(cell).area;
        worstArea = std::max(worstArea, static_cast<double>(std::abs(a.area - exact.area)));
        const Point2 moment = a.area * a.centroid - exact.moment.cast<double>();
        worstMoment = std::max(worstMoment, moment.norm());
    }

    EXPECT_LT(worstArea, 3e-15);
    EXPECT_LT(worstMoment, 3e-15);
    EXPECT_GT(cut, 20000);
}

TEST(RandomPairs, AgreeWithSignedTrianglesOnAndNearALattice)
{
    // Vertices, centres and radii in multiples of 1/4, moved by 0 to 1e-6 of the radius: circle and cell touch,
    // pass through vertices, coincide
    std::mt19937 random(12);
    std::uniform_int_distribution<int> place(-8, 8), size(1, 6), exponent(6, 17);
    std::uniform_real_distribution<double> unit(-1, 1);
    double worst = 0;

    for (int pair = 0; pair < 200000; ++pair)
    {
        const double x = 0.25 * place(random), y = 0.25 * place(random), r = 0.25 * size(random);
        const double w = 0.25 * size(random), h = 0.25 * size(random);
        Polygon cell = pair % 2 ? rectangle(x, y, x + w, y + h) : Polygon{{x, y}, {x + w, y}, {x, y + h}};
        if (pair % 4 > 1)
        {
            const double move = std::pow(10.0, -exponent(random));
            for (Point2& p : cell) p += move * Point2(unit(random), unit(random));
        }
        const Reference exact = bySignedTriangles({0, 0}, r, cell);
        const double area = discPolygon({0, 0}, r, cell).area;
        worst = std::max(worst, static_cast<double>(std::abs(area / (r * r) - exact.area)));
    }
    EXPECT_LT(worst, 3e-15);
}

TEST(RandomPairs, AgreeWithQuadratureOverStrips)
{
    std::mt19937 random(13);
    std::uniform_real_distribution<double> logSize(std::log(0.1), std::log(10.));
    for (int pair = 0; pair < 3000; ++pair)
    {
        const Polygon cell = randomPolygon(random, std::exp(logSize(random)));
        EXPECT_NEAR(unitDisc(cell).area, byStrips(cell), 1e-10);
    }
}
