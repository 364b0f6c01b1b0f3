// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/packing/SizeDistribution.hpp"

#include "nscd/base/Check.hpp"
#include "nscd/base/Random.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

void checkRange(double smallest, double largest)
{
    if (!isPositive(smallest) || !isPositive(largest) || smallest > largest)
    {
        refuse("radii from ", smallest, " to ", largest, " m are not positive and increasing");
    }
}

/// Fraction of the standard normal distribution above x.
double normalTail(double x)
{
    return 0.5 * std::erfc(x / std::sqrt(2.0));
}

/// Quantile of the standard normal distribution between a and b; the tails are taken on the side where they are small.
double cutNormal(double u, double a, double b)
{
    if (a + b < 0)
    {
        return -cutNormal(1 - u, -b, -a);
    }
    const double tail = (1 - u) * normalTail(a) + u * normalTail(b);
    while (b - a > 1e-12 * (std::abs(a) + std::abs(b) + 1))
    {
        const double middle = 0.5 * (a + b);
        (normalTail(middle) > tail ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

void checkCut(double a, double b, double smallest, double largest)
{
    constexpr double farOut = 8;  // deviations: less than 1e-15 of the distribution
    if (a >= b || a > farOut || b < -farOut)
    {
        refuse("radii from ", smallest, " to ", largest, " m hold nothing of the distribution");
    }
}

double sevenDigits(double value)
{
    return static_cast<float>(value);
}

}  // namespace

SizeDistribution constantSize(double radius)
{
    checkRadius(radius);
    return [radius](double) { return radius; };
}

SizeDistribution uniformSize(double smallest, double largest)
{
    checkRange(smallest, largest);
    return [=](double u) { return smallest + u * (largest - smallest); };
}

SizeDistribution normalSize(double mean, double deviation, double smallest, double largest)
{
    checkRange(smallest, largest);
    if (!std::isfinite(mean) || !isPositive(deviation))
    {
        refuse("mean ", mean, " m and standard deviation ", deviation, " m are not finite and positive");
    }
    const double a = (smallest - mean) / deviation, b = (largest - mean) / deviation;
    checkCut(a, b, smallest, largest);
    return [=](double u) { return std::clamp(sevenDigits(mean + deviation * cutNormal(u, a, b)), smallest, largest); };
}

SizeDistribution lognormalSize(double median, double logDeviation, double smallest, double largest)
{
    checkRange(smallest, largest);
    if (!isPositive(median) || !isPositive(logDeviation))
    {
        refuse("median ", median, " m and logarithmic deviation ", logDeviation, " are not positive");
    }
    const double a = std::log(smallest / median) / logDeviation, b = std::log(largest / median) / logDeviation;
    checkCut(a, b, smallest, largest);
    return [=](double u)
    { return std::clamp(sevenDigits(median * std::exp(logDeviation * cutNormal(u, a, b))), smallest, largest); };
}

template <int D>
SizeDistribution tabulatedSize(const std::vector<double>& radii, const std::vector<double>& passing, SieveCurve curve)
{
    const std::size_t n = radii.size();
    if (n < 2 || passing.size() != n)
    {
        refuse("sieve curve: ", n, " radii and ", passing.size(), " fractions; at least two of each are needed");
    }
    std::vector<double> number{0};                      // of grains below each radius, not yet a fraction
    const auto numberBelow = [=](double low, double r)  // per mass in the interval and its width, from its lower end
    {
        const double difference = 1 / low - 1 / r;
        return D == 2 ? difference : difference * (1 / low + 1 / r) / 2;
    };
    for (std::size_t i = 0; i < n; ++i)
    {
        checkRadius(radii[i]);
        const bool rises = i == 0 || (radii[i] > radii[i - 1] && passing[i] >= passing[i - 1]);
        if (!std::isfinite(passing[i]) || !rises)
        {
            refuse("sieve curve: entry ", i, ", ", passing[i], " below ", radii[i], " m, does not rise");
        }
        if (i > 0)
        {
            const double part = passing[i] - passing[i - 1], width = radii[i] - radii[i - 1];
            number.push_back(
                number.back()
                + (curve == SieveCurve::byNumber ? part : part / width * numberBelow(radii[i - 1], radii[i])));
        }
    }
    if (passing.front() != 0 || passing.back() != 1)
    {
        refuse("sieve curve: from ", passing.front(), " to ", passing.back(), " instead of from 0 to 1");
    }
    return [=](double u)
    {
        const double wanted = u * number.back();
        const auto above = std::upper_bound(number.begin() + 1, number.end() - 1, wanted);
        const std::size_t i = above - number.begin();
        const double low = radii[i - 1], high = radii[i];
        const double step = number[i] - number[i - 1];
        const double part = step > 0 ? (wanted - number[i - 1]) / step : 0;
        if (curve == SieveCurve::byNumber)
        {
            return low + part * (high - low);
        }
        // 1/r or 1/r^2 falls evenly with the number
        const double a = 1 / low, b = 1 / high;
        const double inverse = D == 2 ? a + part * (b - a) : std::sqrt(a * a + part * (b * b - a * a));
        return std::clamp(1 / inverse, low, high);
    };
}

template <int D>
std::vector<double> drawRadii(const SizeDistribution& sizes, const Box<D>& box, double solidFraction,
                              std::uint64_t seed)
{
    checkBox<D>(box);
    if (!std::isfinite(solidFraction) || solidFraction <= 0 || solidFraction >= 1)
    {
        refuse("solid fraction ", solidFraction, " is not between 0 and 1");
    }
    const auto volume = [](double r) { return D == 2 ? 3.14159265358979324 * r * r : 4.18879020478639098 * r * r * r; };
    constexpr int parts = 10000;
    double mean = 0;
    for (int i = 0; i < parts; ++i)
    {
        mean += volume(sizes((i + 0.5) / parts)) / parts;
    }
    const double number = std::round(solidFraction * (box.upper - box.lower).prod() / mean);
    if (number < 1 || number > 1e9)
    {
        refuse("solid fraction ", solidFraction, " makes ", number, " grains in this box");
    }
    Random random(~seed);  // not the sequence that places the grains
    std::vector<double> radii;
    for (int i = 0; i < number; ++i)
    {
        radii.push_back(sizes((i + random.uniform(0, 1)) / number));
    }
    return radii;
}

template SizeDistribution tabulatedSize<2>(const std::vector<double>&, const std::vector<double>&, SieveCurve);
template SizeDistribution tabulatedSize<3>(const std::vector<double>&, const std::vector<double>&, SieveCurve);
template std::vector<double> drawRadii<2>(const SizeDistribution&, const Box<2>&, double, std::uint64_t);
template std::vector<double> drawRadii<3>(const SizeDistribution&, const Box<3>&, double, std::uint64_t);

}  // namespace nscd
