// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/packing/DensePacking.hpp"

#include "nscd/base/Check.hpp"
#include "nscd/packing/SoftGrains.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Radii are packed a little larger, so that pushing ends in a finite time and without any overlap.
constexpr double clearance = 1e-4;

/// Overlaps of agitated grains over the mean radius: spheres that are smaller by these flow, but only just.
constexpr double agitation = 0.055;

/// Jams with larger overlaps over the mean radius do not dissolve.
constexpr double dissolvable = 0.06;

constexpr double fastestRate = 0.1, slowestRate = 1e-3;

template <int D>
void check(const Box<D>& box, const std::vector<double>& radii, const std::array<bool, D>& periodic)
{
    checkBox<D>(box);
    for (const double radius : radii)
    {
        checkRadius(radius);
        for (int d = 0; d < D; ++d)
        {
            const double width = box.upper[d] - box.lower[d];
            if (2 * radius * (1 + clearance) > width)
            {
                refuse("radius ", radius, " m: the box is only ", width, " m wide");
            }
            if (periodic[d] && 6 * radius > width)
            {
                refuse("radius ", radius, " m: the periodic box is only ", width, " m wide, less than three grains");
            }
        }
    }
}

}  // namespace

template <int D>
Vectors<D> densePacking(const Box<D>& box, const std::vector<double>& radii, std::uint64_t seed,
                        const std::array<bool, D>& periodic)
{
    check<D>(box, radii, periodic);
    if (radii.empty())
    {
        return {};
    }
    const Vector<D> size = box.upper - box.lower;
    Random random(seed);
    Vectors<D> centres(radii.size());
    double meanRadius = 0;
    std::vector<double> enlarged(radii);
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
        enlarged[i] *= 1 + clearance;
        meanRadius += radii[i] / static_cast<double>(radii.size());
        for (int d = 0; d < D; ++d)
        {
            const double inset = periodic[d] ? 0 : enlarged[i];
            centres[i][d] = random.uniform(inset, size[d] - inset);
        }
    }

    constexpr double enough = 0.99 * clearance;
    SoftGrains<D> grains(size, periodic, enlarged, centres);
    grains.quench(enough);
    const bool mayDissolve = grains.typicalOverlap() < dissolvable * meanRadius;
    for (double rate = fastestRate; mayDissolve && grains.deepestOverlap() > enough && rate > slowestRate; rate /= 3)
    {
        grains.anneal(random, agitation * meanRadius, rate, enough);
        grains.quench(enough);
    }
    if (grains.deepestOverlap() > enough)
    {
        throw std::runtime_error("no packing of " + std::to_string(radii.size())
                                 + " grains was found that is so dense; overlaps of up to "
                                 + std::to_string(100 * grains.deepestOverlap()) + " % of a diameter are left");
    }
    for (std::size_t i = 0; i < centres.size(); ++i)
    {
        centres[i] = box.lower + grains.centres()[i];
    }
    return centres;
}

template Vectors<2> densePacking<2>(const Box<2>&, const std::vector<double>&, std::uint64_t,
                                    const std::array<bool, 2>&);
template Vectors<3> densePacking<3>(const Box<3>&, const std::vector<double>&, std::uint64_t,
                                    const std::array<bool, 3>&);

}  // namespace nscd
