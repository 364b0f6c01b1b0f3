// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/NearBodies.hpp"

#include "nscd/search/Neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

/// Call f(distance) for a body and each of its periodic images nearer than 'reach' [m], 'way' being the vector to one
/// of them; of a grain and its own images one of each two opposite ones.
template <int D, class F>
void forImages(Vector<D> way, const std::array<double, 3>& period, double reach, bool own, F&& f)
{
    std::array<int, D> most{}, n{};
    for (int d = 0; d < D; ++d)
    {
        if (period[d] > 0)
        {
            way[d] -= period[d] * std::round(way[d] / period[d]);
            most[d] = static_cast<int>(reach / period[d] + 0.5);
        }
        n[d] = -most[d];
    }
    const std::array<int, D> none{};
    for (int d = 0; d < D;)
    {
        Vector<D> image = way;
        for (int k = 0; k < D; ++k)
        {
            image[k] += n[k] * period[k];
        }
        if (image.squaredNorm() < reach * reach && (!own || n > none))
        {
            f(image.norm());
        }
        for (d = 0; d < D && ++n[d] > most[d]; ++d)
        {
            n[d] = -most[d];
        }
    }
}

}  // namespace

template <int D>
std::vector<NearBodies> nearBodies(const Grains<D>& grains, const WallContact<D>& walls, double reach,
                                   const std::array<double, 3>& period)
{
    std::vector<NearBodies> result;
    if (grains.size() == 0)
    {
        return result;
    }
    const Vectors<D> x = wrapped<D>(grains.position, period);
    const double largest = *std::max_element(grains.radius.begin(), grains.radius.end());
    const Neighbours<D> neighbours(x, grains.radius, 2 * std::max(reach - 1, 0.0) * largest, period);
    std::vector<int> near;
    for (int i = 0; i < static_cast<int>(grains.size()); ++i)
    {
        near.assign(1, i);
        neighbours.forNear(i, i, [&](int j) { near.push_back(j); });
        std::sort(near.begin(), near.end());
        near.erase(std::unique(near.begin(), near.end()), near.end());
        for (const int j : near)
        {
            forImages<D>(x[j] - x[i], period, reach * (grains.radius[i] + grains.radius[j]), i == j,
                         [&](double distance) { result.push_back({i, j, distance}); });
        }
        const double farthest = 2 * reach * grains.radius[i];
        walls.forNear(grains.position[i], farthest,
                      [&](int wall)
                      {
                          const Vector<D> place = walls.image(wall, grains.position[i]);
                          const auto approach = walls.approach(wall, place, grains.radius[i]);
                          const double distance = approach ? approach->gap + grains.radius[i] : farthest;
                          if (distance < farthest)
                          {
                              result.push_back({i, ~wall, distance});
                          }
                      });
    }
    return result;
}

template std::vector<NearBodies> nearBodies<2>(const Grains<2>&, const WallContact<2>&, double,
                                               const std::array<double, 3>&);
template std::vector<NearBodies> nearBodies<3>(const Grains<3>&, const WallContact<3>&, double,
                                               const std::array<double, 3>&);

}  // namespace nscd
