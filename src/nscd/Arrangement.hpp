// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/Candidates.hpp"
#include "nscd/ContactTable.hpp"

#include <cmath>

namespace nscd
{

/// What contact geometry needs of the grains, in solver order, and the walls.
template <int D>
class Arrangement
{
public:
    Arrangement(const Walls<D>& walls, const ContactTable& table)
        : walls_(walls), table_(table)
    {
        for (const auto& wall : walls)
        {
            wallMaterial_.push_back(materialOf(wall));
        }
    }

    const WallContact<D>& walls() const { return walls_; }
    std::size_t wallCount() const { return wallMaterial_.size(); }

    /// Take over radii and materials in a new order, and positions.
    void arrange(const Grains<D>& grains, const std::vector<int>& order)
    {
        const std::size_t n = order.size();
        radius_.resize(n);
        material_.resize(n);
        for (std::size_t k = 0; k < n; ++k)
        {
            radius_[k] = grains.radius[order[k]];
            material_[k] = grains.material[order[k]];
        }
        move(grains, order);
    }

    /// Take over positions.
    void move(const Grains<D>& grains, const std::vector<int>& order)
    {
        position_.resize(order.size());
        for (std::size_t k = 0; k < order.size(); ++k)
        {
            position_[k] = grains.position[order[k]];
        }
    }

    /// Normal and gap; nothing when a pair is not a contact of its own (see WallContact).
    std::optional<Approach<D>> approach(const Pair& pair) const
    {
        const Vector<D>& x = position_[pair.first];
        const double radius = radius_[pair.first];
        if (pair.second < 0)
        {
            return walls_.approach(~pair.second, x, radius);
        }
        const Vector<D> toSecond = position_[pair.second] - x;
        const double distance = toSecond.norm();
        const double gap = distance - radius - radius_[pair.second];
        if (distance > 0)
        {
            return Approach<D>{toSecond * (1 / distance), gap};
        }
        return Approach<D>{Vector<D>::UnitX(), gap};
    }

    /// Penetration of a pair [m]; 0 when apart.
    double depth(const Pair& pair) const
    {
        if (pair.second >= 0)
        {
            const double touching = radius_[pair.first] + radius_[pair.second];
            const double square = (position_[pair.second] - position_[pair.first]).squaredNorm();
            return square < touching * touching ? touching - std::sqrt(square) : 0;
        }
        const auto wall = approach(pair);
        return wall ? std::max(0.0, -wall->gap) : 0;
    }

    /// Smallest radius of a pair [m].
    double radius(const Pair& pair) const
    {
        return pair.second < 0 ? radius_[pair.first] : std::min(radius_[pair.first], radius_[pair.second]);
    }

    const ContactParameters& parameters(const Pair& pair) const
    {
        return table_(material_[pair.first], pair.second < 0 ? wallMaterial_[~pair.second] : material_[pair.second]);
    }

private:
    WallContact<D> walls_;
    ContactTable table_;
    std::vector<int> wallMaterial_;
    Vectors<D> position_;
    std::vector<double> radius_;
    std::vector<int> material_;
};

}  // namespace nscd
