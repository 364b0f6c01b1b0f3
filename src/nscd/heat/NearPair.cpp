// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/NearPair.hpp"

#include "nscd/base/Pi.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

constexpr double stefanBoltzmann = 5.670374419e-8;   // [W/m^2/K^4]

bool isWall(const NearPair& pair)
{
    return std::isinf(pair.secondRadius);
}

double square(double x)
{
    return x * x;
}

/// Two bodies along the line of their centres: thickness of the fluid between them beside it.
struct Layer
{
    double a, b;       ///< radii, the first the smaller; of a wall none
    double distance;   ///< such that the gap is not below the least
    double from, to;   ///< thickness on the line of centres, and where heat no longer crosses
    bool wall;

    Layer(const NearPair& pair, double lens, double leastGap)
        : a(std::min(pair.firstRadius, pair.secondRadius)),
          b(isWall(pair) ? 0 : std::max(pair.firstRadius, pair.secondRadius)),
          distance(std::max(pair.distance, a + b + leastGap)),
          from(distance - a - b),
          to(from),
          wall(isWall(pair))
    {
        const double reach = (1 + lens) * a;
        if (distance >= reach + b)
        {
            return;
        }
        // Where the layer around the smaller one meets the other's surface, not beyond its own rim
        const double along = wall ? distance : (square(reach) - square(b) + square(distance)) / (2 * distance);
        to = thickness(std::min({square(reach) - square(along), square(a), square(pair.beside)}));
    }

    /// At the square of a distance from the line of centres.
    double thickness(double r2) const
    {
        return distance - std::sqrt(std::max(square(a) - r2, 0.0))
               - (wall ? 0 : std::sqrt(std::max(square(b) - r2, 0.0)));
    }

    /// Height of the smaller one's surface above its centre where the layer has a thickness.
    double height(double l) const
    {
        const double e = distance - l;
        return wall ? e : 0.5 * (e + (square(a) - square(b)) / e);
    }

    /// Square of the distance from the line of centres.
    double beside(double l) const { return std::max(square(a) - square(height(l)), 0.0); }

    /// d(beside)/dl.
    double spread(double l) const
    {
        const double e = distance - l, c = height(l);
        return wall ? 2 * c : 2 * c * (e - c) / e;
    }
};

NearPair ofRow(const NearPair& pair, double& pairs)
{
    pairs = pair.length / (isWall(pair) ? 2 * pair.firstRadius : pair.firstRadius + pair.secondRadius);
    return pair;
}

}  // namespace

double gap::spheres(const NearPair& pair, double lens, double leastGap)
{
    const Layer layer(pair, lens, leastGap);
    const double d = layer.distance, l = layer.from, m = layer.to;
    if (m <= l)
    {
        return 0;
    }
    if (layer.wall)
    {
        return 2 * pi * (d * std::log(m / l) - (m - l));
    }
    const double even = 0.5 * (d * std::log(m / l) - (m - l));
    const double p = d - l, q = d - m;
    const double uneven = std::log(m * p / (l * q)) / (d * d * d) + (1 / q - 1 / p) / (d * d)
                          + (1 / square(q) - 1 / square(p)) / (2 * d);
    return pi * (even - 0.5 * square(square(layer.a) - square(layer.b)) * uneven);
}

double gap::cylinders(const NearPair& pair, double lens, double leastGap)
{
    const Layer layer(pair, lens, leastGap);
    if (layer.to <= layer.from)
    {
        return 0;
    }
    // l = from (1 + sinh^2 t): smooth however narrow the gap is; Simpson's rule
    constexpr int intervals = 64;
    const double root = std::sqrt(layer.from), end = std::asinh(std::sqrt(layer.to / layer.from - 1));
    const auto f = [&](double t)
    {
        const double z = root * std::sinh(t), l = layer.from + z * z;
        const double x = std::sqrt(layer.beside(l));
        // Near the line of centres beside is spread z^2
        return layer.spread(l) * (x > 0 ? z / x : 1 / std::sqrt(layer.spread(layer.from)))
               / (root * std::cosh(t));
    };
    double sum = f(0) + f(end);
    for (int i = 1; i < intervals; ++i)
    {
        sum += (i % 2 ? 4 : 2) * f(end * i / intervals);
    }
    return 2 * pair.length * sum * end / (3 * intervals);
}

double gap::rowOfSpheres(const NearPair& pair, double lens, double leastGap)
{
    double pairs;
    const NearPair one = ofRow(pair, pairs);
    return pairs * spheres(one, lens, leastGap);
}

namespace
{

/// Of the directions in which a wall is seen, the cosine of the outermost with its normal.
double cosineOfRim(const NearPair& pair, double farthest)
{
    const double distance = std::max(pair.distance, pair.firstRadius);
    return std::min(distance / std::min(farthest, std::hypot(distance, pair.beside)), 1.0);
}

}  // namespace

double sight::spheres(const NearPair& pair, double farthest)
{
    const auto seen = [&](double own, double other)
    {
        const double sine = std::min(other / pair.distance, 1.0);
        return 4 * pi * square(own) * 0.5 * (1 - std::sqrt(1 - square(sine)));
    };
    if (isWall(pair))
    {
        const double cosine = cosineOfRim(pair, farthest);
        return 2 * pi * square(pair.firstRadius) * (1 - cosine);
    }
    return 0.5 * (seen(pair.firstRadius, pair.secondRadius) + seen(pair.secondRadius, pair.firstRadius));
}

double sight::cylinders(const NearPair& pair, double farthest)
{
    if (isWall(pair))
    {
        const double cosine = cosineOfRim(pair, farthest);
        return 2 * pair.firstRadius * pair.length * std::acos(cosine);
    }
    const double sum = pair.firstRadius + pair.secondRadius, difference = pair.firstRadius - pair.secondRadius;
    const double d = std::max(pair.distance, sum);
    const auto string = [d](double r) { return std::sqrt(square(d) - square(r)) + r * std::asin(r / d); };
    return pair.length * (string(sum) - string(difference));
}

double sight::rowOfSpheres(const NearPair& pair, double farthest)
{
    double pairs;
    const NearPair one = ofRow(pair, pairs);
    return pairs * spheres(one, farthest);
}

double greyness(double firstEmissivity, double secondEmissivity)
{
    return 1 / (1 / firstEmissivity + 1 / secondEmissivity - 1);
}

double radiationCoefficient(double first, double second)
{
    return stefanBoltzmann * (square(first) + square(second)) * (first + second);
}

}  // namespace nscd
