// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/search/Neighbours.hpp"

#include <cmath>
#include <map>

namespace nscd
{

namespace
{

/// Range of sizes that a radius belongs to: 0 for the largest, then one for each factor of two.  Sizes that differ by
/// less than 'narrow' are one range.
int rangeOf(double radius, double smallest, double largest)
{
    constexpr double narrow = 3;
    return largest < narrow * smallest ? 0 : static_cast<int>(std::floor(std::log2(largest / radius)));
}

}  // namespace

template <int D>
Neighbours<D>::Neighbours(const Vectors<D>& positions, const std::vector<double>& radii, double skin,
                          const std::array<double, 3>& period)
    : positions_(positions), radii_(radii), skin_(skin)
{
    if (radii.empty())
    {
        return;
    }
    const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
    std::map<int, std::vector<Seat>> ranges;
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
        ranges[rangeOf(radii[i], *smallest, *largest)].push_back({positions[i], radii[i], static_cast<int>(i)});
    }
    for (auto& [range, seats] : ranges)
    {
        double radius = 0;
        for (const Seat& seat : seats)
        {
            radius = std::max(radius, seat.radius);
        }
        addImages(seats, *largest + radius + skin, period);
        Vectors<D> x;
        x.reserve(seats.size());
        for (const Seat& seat : seats)
        {
            x.push_back(seat.x);
        }
        levels_.push_back({radius, CellGrid<D>(x, 2 * radius + skin), {}});
        Level& level = levels_.back();
        level.seats.reserve(seats.size());
        for (const int s : level.grid.members())
        {
            level.seats.push_back(seats[s]);
        }
    }
}

template <int D>
void Neighbours<D>::addImages(std::vector<Seat>& seats, double reach, const std::array<double, 3>& period)
{
    for (int d = 0; d < D; ++d)
    {
        if (period[d] > 0)
        {
            const std::size_t own = seats.size();
            for (std::size_t s = 0; s < own; ++s)
            {
                for (const double shift : {-period[d], period[d]})
                {
                    Seat image = seats[s];
                    image.x[d] += shift;
                    for (; image.x[d] > -reach && image.x[d] < period[d] + reach; image.x[d] += shift)
                    {
                        seats.push_back(image);
                    }
                }
            }
        }
    }
}

template class Neighbours<2>;
template class Neighbours<3>;

}  // namespace nscd
