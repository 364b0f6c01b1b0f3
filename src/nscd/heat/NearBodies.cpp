// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/NearBodies.hpp"

#include "nscd/search/Neighbours.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Part of the way to a wall that does not touch those that it meets there.
constexpr double nearly = 1 - 1e-6;

/// Of the ways to two opposite images of a grain, one.
template <int D>
bool isFirstOfTwo(const Vector<D>& way)
{
    const Vector<D> none = Vector<D>::Zero();
    return std::lexicographical_compare(none.begin(), none.end(), way.begin(), way.end());
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
    for (int i = 0; i < static_cast<int>(grains.size()); ++i)
    {
        bool hasWalls = false;
        walls.forNear(grains.position[i], reach * (grains.radius[i] + largest), [&](int) { hasWalls = true; });
        neighbours.forImages(i, i,
                             [&](int j, const Vector<D>& way)
                             {
                                 const double distance = way.norm();
                                 if (distance < reach * (grains.radius[i] + grains.radius[j])
                                     && (j != i || isFirstOfTwo<D>(way))
                                     && !(hasWalls && walls.separates(grains.position[i], way)))
                                 {
                                     result.push_back({i, j, distance});
                                 }
                             });
        const double farthest = 2 * reach * grains.radius[i];
        std::vector<NearPlane<D>> planes;
        walls.forNear(grains.position[i], farthest,
                      [&](int wall)
                      {
                          const Vector<D> place = walls.image(wall, grains.position[i]);
                          const auto approach = walls.approach(wall, place, grains.radius[i]);
                          const double distance = approach ? approach->gap + grains.radius[i] : farthest;
                          if (distance < farthest && !walls.separates(place, nearly * walls.way(wall, place)))
                          {
                              planes.push_back({wall, distance, approach->normal});
                          }
                      });
        for (std::size_t k = 0; k < planes.size(); ++k)
        {
            if (const auto own = ownPart<D>(planes, k, farthest))
            {
                result.push_back({i, ~planes[k].wall, planes[k].distance, *own});
            }
        }
    }
    return result;
}

template std::vector<NearBodies> nearBodies<2>(const Grains<2>&, const WallContact<2>&, double,
                                               const std::array<double, 3>&);
template std::vector<NearBodies> nearBodies<3>(const Grains<3>&, const WallContact<3>&, double,
                                               const std::array<double, 3>&);

}  // namespace nscd
