// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Candidates.hpp"
#include "nscd/contact/ContactTable.hpp"

#include <cmath>

namespace nscd
{

/// What contact geometry needs of the grains' members, in solver order, and the walls.
template <int D>
class Arrangement
{
public:
    Arrangement(const Walls<D>& walls, const ContactTable& table, const std::array<double, 3>& period)
        : walls_(walls, period), table_(table), period_(period),
          periodic_(*std::max_element(period.begin(), period.end()) > 0)
    {
        for (const auto& wall : walls)
        {
            wallMaterial_.push_back(materialOf(wall));
            wallBody_.push_back(bodyOf(wall));
        }
    }

    const WallContact<D>& walls() const { return walls_; }
    WallContact<D>& walls() { return walls_; }

    /// Take over radii and materials in a new order, and positions.
    void arrange(const Grains<D>& grains, const Members<D>& members, const Candidates<D>& candidates)
    {
        const std::vector<int>& order = candidates.memberOrder();
        radius_.resize(order.size());
        material_.resize(order.size());
        for (std::size_t k = 0; k < order.size(); ++k)
        {
            radius_[k] = members.radius()[order[k]];
            material_[k] = grains.material[members.grain(order[k])];
        }
        ofCluster_.clear();
        for (std::size_t k = 0; k < order.size() && !members.simple(); ++k)
        {
            ofCluster_.push_back(grains.shape[members.grain(order[k])] >= 0);
        }
        ambient_.clear();
        move(grains.position, grains.orientation, members, candidates);
    }

    /// Take over ambient values, one per grain.
    void surround(const std::vector<double>& ambient, const Members<D>& members, const Candidates<D>& candidates)
    {
        const std::vector<int>& order = candidates.memberOrder();
        ambient_.resize(ambient.empty() ? 0 : order.size());
        for (std::size_t k = 0; k < ambient_.size(); ++k)
        {
            ambient_[k] = ambient[members.grain(order[k])];
        }
    }

    /// Take over positions.
    void move(const Vectors<D>& positions, const Orientations<D>& orientations, const Members<D>& members,
              const Candidates<D>& candidates)
    {
        const std::vector<int>& order = candidates.memberOrder();
        position_.resize(order.size());
        arm_.resize(members.simple() ? 0 : order.size());
        for (std::size_t k = 0; k < order.size(); ++k)
        {
            const int grain = members.grain(order[k]);
            position_[k] = positions[grain];
            if (!members.simple())
            {
                arm_[k] = members.arm(order[k], orientations[grain]);
                position_[k] += arm_[k];
            }
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
        const Vector<D> toSecond = separation(pair);
        const double distance = toSecond.norm();
        const double gap = distance - radius - radius_[pair.second];
        if (distance > 0)
        {
            return Approach<D>{toSecond * (1 / distance), gap};
        }
        return Approach<D>{Vector<D>::UnitX(), gap};
    }

    /// Do two grains that are not clusters, or one and a wall, stay apart by more than a margin >= 0 [m] when their
    /// separation changes by 'motion' [m]?  What approach() says of it, to first order in the motion, without roots;
    /// of a wall only what is known quickly.
    bool staysApart(const Pair& pair, double margin, const Vector<D>& motion) const
    {
        if (pair.second < 0)
        {
            const double reach = radius_[pair.first] + margin + motion.norm();
            return walls_.isBeyond(~pair.second, position_[pair.first], reach);
        }
        const Vector<D> toSecond = separation(pair);
        const double reach = radius_[pair.first] + radius_[pair.second] + margin;
        const double square = toSecond.squaredNorm(), later = square + toSecond.dot(motion);
        return square > 0 && later > 0 && later * later > reach * reach * square;
    }

    /// Penetration of a pair [m]; 0 when apart.
    double depth(const Pair& pair) const
    {
        if (pair.second >= 0)
        {
            const double touching = radius_[pair.first] + radius_[pair.second];
            const double square = separation(pair).squaredNorm();
            return square < touching * touching ? touching - std::sqrt(square) : 0;
        }
        if (staysApart(pair, 0, Vector<D>::Zero()))
        {
            return 0;
        }
        const auto wall = approach(pair);
        return wall ? std::max(0.0, -wall->gap) : 0;
    }

    /// From the centre of the first body to the contact, and the same for the second member's body [m]: to the middle
    /// of an overlap, but to the body's own surface across a gap, which will be closed when there is an impulse.
    Vector<D> firstArm(const Pair& pair, const Approach<D>& approach) const
    {
        const Vector<D> toContact = (radius_[pair.first] + std::min(0.0, 0.5 * approach.gap)) * approach.normal;
        return arm_.empty() ? toContact : Vector<D>(arm_[pair.first] + toContact);
    }

    Vector<D> secondArm(const Pair& pair, const Approach<D>& approach) const
    {
        const Vector<D> toContact = -(radius_[pair.second] + std::min(0.0, 0.5 * approach.gap)) * approach.normal;
        return arm_.empty() ? toContact : Vector<D>(arm_[pair.second] + toContact);
    }

    /// From the centre of a member's body to its own [m].
    Vector<D> arm(int member) const { return arm_.empty() ? Vector<D>(Vector<D>::Zero()) : arm_[member]; }

    /// The point in the middle of an overlap [m], seen from a wall if it is one; across a gap the point on the first
    /// one's surface, or on the wall's.
    Vector<D> contactPoint(const Pair& pair, const Approach<D>& approach) const
    {
        const Vector<D>& x = position_[pair.first];
        const Vector<D> centre = periodic_ && pair.second < 0 ? walls_.image(~pair.second, x) : x;
        const double beyond = approach.gap < 0 ? 0.5 * approach.gap : pair.second < 0 ? approach.gap : 0;
        return centre + (radius_[pair.first] + beyond) * approach.normal;
    }

    /// Radius of a member [m].
    double radiusOf(int member) const { return radius_[member]; }

    /// Is one of the pair part of a cluster?  A member at the centre of mass is: it turns with the cluster's inertia.
    bool isOfCluster(const Pair& pair) const
    {
        return !ofCluster_.empty() && (ofCluster_[pair.first] || (pair.second >= 0 && ofCluster_[pair.second]));
    }

    bool hasClusters() const { return !arm_.empty(); }

    /// From the centre of a member to the nearest point of the wall that it is paired with [m].
    Vector<D> wayToWall(const Pair& pair) const { return walls_.way(~pair.second, position_[pair.first]); }

    /// Body that a wall belongs to; -1 when it is fixed.
    int wallBody(int wall) const { return wallBody_[wall]; }

    /// Smallest radius of a pair [m].
    double radius(const Pair& pair) const
    {
        return pair.second < 0 ? radius_[pair.first] : std::min(radius_[pair.first], radius_[pair.second]);
    }

    /// R_i + R_j of two members [m].
    double sumOfRadii(const Pair& pair) const { return radius_[pair.first] + radius_[pair.second]; }

    /// R with 1/R = 1/R_i + 1/R_j [m].
    double effectiveRadius(const Pair& pair) const
    {
        const double r = radius_[pair.first];
        return pair.second < 0 ? r : r * radius_[pair.second] / (r + radius_[pair.second]);
    }

    /// What surrounds a contact, in a unit that its law knows: the mean of what surrounds its grains; 0 for nothing.
    double ambient(const Pair& pair) const
    {
        if (ambient_.empty())
        {
            return 0;
        }
        const double first = ambient_[pair.first];
        return pair.second < 0 ? first : 0.5 * (first + ambient_[pair.second]);
    }

    const ContactParameters& parameters(const Pair& pair) const
    {
        return table_(material_[pair.first], pair.second < 0 ? wallMaterial_[~pair.second] : material_[pair.second]);
    }

private:
    Vector<D> separation(const Pair& pair) const
    {
        Vector<D> toSecond = position_[pair.second] - position_[pair.first];
        if (periodic_)
        {
            for (int d = 0; d < D; ++d)
            {
                if (period_[d] > 0)
                {
                    toSecond[d] -= period_[d] * std::round(toSecond[d] / period_[d]);
                }
            }
        }
        return toSecond;
    }

    WallContact<D> walls_;
    ContactTable table_;
    std::array<double, 3> period_;
    bool periodic_;
    std::vector<int> wallMaterial_, wallBody_;
    Vectors<D> position_, arm_;
    std::vector<double> radius_;
    std::vector<double> ambient_;   ///< empty for nothing
    std::vector<int> material_;
    std::vector<char> ofCluster_;   ///< of each member; empty without clusters
};

}  // namespace nscd
