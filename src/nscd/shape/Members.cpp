// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/shape/Members.hpp"

#include <algorithm>
#include <numeric>

namespace nscd
{

template <int D>
Members<D>::Members(const Grains<D>& grains)
    : simple_(std::all_of(grains.shape.begin(), grains.shape.end(), [](int shape) { return shape < 0; })),
      first_(grains.size() + 1)
{
    if (simple_)
    {
        std::iota(first_.begin(), first_.end(), 0);
        grain_.assign(first_.begin(), first_.end() - 1);
        radius_ = grains.radius;
        return;
    }
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const double size = grains.radius[i];
        if (grains.shape[i] < 0)
        {
            arm_.push_back(Vector<D>::Zero());
            radius_.push_back(size);
        }
        else
        {
            const Cluster<D>& cluster = grains.clusters[grains.shape[i]];
            for (std::size_t m = 0; m < cluster.radius.size(); ++m)
            {
                arm_.push_back(size * cluster.centre[m]);
                radius_.push_back(size * cluster.radius[m]);
            }
        }
        grain_.resize(radius_.size(), static_cast<int>(i));
        first_[i + 1] = static_cast<int>(radius_.size());
    }
}

template <int D>
Vectors<D> Members<D>::positions(const Vectors<D>& grains, const Orientations<D>& orientations) const
{
    if (simple_)
    {
        return grains;
    }
    Vectors<D> x(size());
    for (std::size_t m = 0; m < size(); ++m)
    {
        x[m] = grains[grain_[m]] + orientations[grain_[m]] * arm_[m];
    }
    return x;
}

template class Members<2>;
template class Members<3>;

}  // namespace nscd
