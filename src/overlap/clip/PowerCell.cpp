// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/clip/PowerCell.hpp"

namespace overlap
{

template <int D>
std::optional<std::vector<HalfSpace<D>>> powerCell(const std::vector<Sphere<D>>& members, std::size_t i)
{
    std::vector<HalfSpace<D>> cuts;
    const Sphere<D>& own = members[i];
    for (std::size_t j = 0; j < members.size(); ++j)
    {
        if (j == i) continue;
        const auto d = (members[j].centre - own.centre).eval();
        const double length = d.norm();
        const double power = (own.radius - members[j].radius) * (own.radius + members[j].radius);
        const double reach = 2 * length * own.radius, place = length * length + power;
        if (length == 0 ? power > 0 || (power == 0 && i < j) : place >= reach) continue;
        if (length == 0 || place <= -reach) return std::nullopt;
        cuts.push_back({d / length, own.centre + place / (2 * length * length) * d});
    }
    return cuts;
}

template std::optional<std::vector<HalfSpace<2>>> powerCell(const std::vector<Sphere<2>>&, std::size_t);
template std::optional<std::vector<HalfSpace<3>>> powerCell(const std::vector<Sphere<3>>&, std::size_t);

}  // namespace overlap
