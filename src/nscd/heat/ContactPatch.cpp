// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/ContactPatch.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

template <int D>
std::vector<double> joinedForces(const std::vector<ContactPatch<D>>& patches)
{
    std::vector<int> order(patches.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return patches[a].grain < patches[b].grain; });
    std::vector<double> factors(patches.size(), 1.0);
    for (auto begin = order.begin(), end = begin; begin != order.end(); begin = end)
    {
        end = std::find_if(begin, order.end(), [&](int i) { return patches[i].grain != patches[*begin].grain; });
        for (auto i = begin; i != end; ++i)
        {
            const ContactPatch<D>& own = patches[*i];
            for (auto j = begin; j != end; ++j)
            {
                const ContactPatch<D>& other = patches[*j];
                const double apart = (own.point - other.point).norm(), both = own.radius + other.radius;
                if (own.wall != other.wall && apart < both)
                {
                    factors[*i] += (1 - apart / both) * other.meanForce / own.force;
                }
            }
        }
    }
    return factors;
}

template std::vector<double> joinedForces<2>(const std::vector<ContactPatch<2>>&);
template std::vector<double> joinedForces<3>(const std::vector<ContactPatch<3>>&);

}  // namespace nscd
