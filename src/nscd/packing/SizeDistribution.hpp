// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/packing/Packing.hpp"

#include <functional>

namespace nscd
{

/// Distribution of radii as its quantile function: the radius [m] below which a fraction 0 <= u <= 1 of the grains
/// lies, by number.
using SizeDistribution = std::function<double(double)>;

/// All of one radius [m].  Throws std::invalid_argument unless it is > 0.
SizeDistribution constantSize(double radius);

/// Radii evenly spread.  Throws std::invalid_argument unless 0 < smallest <= largest.
SizeDistribution uniformSize(double smallest, double largest);

/// Normal distribution, of which the part between smallest and largest is kept; rounded to seven digits, so that no
/// difference between mathematical libraries is seen.  Mean and deviation are those before the cut.  Throws
/// std::invalid_argument unless deviation > 0, 0 < smallest < largest, and part of the distribution lies between them.
SizeDistribution normalSize(double mean, double deviation, double smallest, double largest);

/// The same for the logarithm: of median [m] and standard deviation 'logDeviation' of ln r.
SizeDistribution lognormalSize(double median, double logDeviation, double smallest, double largest);

/// What a sieve curve counts.
enum class SieveCurve
{
    byNumber,
    byMass
};

/// Radii of which the fraction passing[i] is smaller than radii[i], by number or by mass, and that are evenly spread
/// between two entries, by number or by mass.  In 2-D mass goes with r^2, in 3-D with r^3.  Throws
/// std::invalid_argument unless there are at least two entries, radii > 0 increase and passing rises from 0 to 1.
template <int D>
SizeDistribution tabulatedSize(const std::vector<double>& radii, const std::vector<double>& passing, SieveCurve curve);

/// Radii [m] of as many grains as fill the solid fraction of the box: each of equal parts of the distribution, by
/// number, gives one grain, drawn from that part.  The fraction is met to within the volume of the largest grain.
/// The same for a seed on every platform.  Throws std::invalid_argument for an empty box, a solid fraction outside
/// (0, 1), or a box that this fills with less than one grain.
template <int D>
std::vector<double> drawRadii(const SizeDistribution& sizes, const Box<D>& box, double solidFraction,
                              std::uint64_t seed);

}  // namespace nscd
