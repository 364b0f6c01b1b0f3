// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/shape/Grains.hpp"

namespace nscd
{

/// The discs or spheres that come into contact: a grain that is one itself, or each of those a cluster is made of.
/// They are numbered grain by grain.
template <int D>
class Members
{
public:
    Members() = default;
    explicit Members(const Grains<D>& grains);

    std::size_t size() const { return grain_.size(); }

    /// Is every grain its own single member?
    bool simple() const { return simple_; }

    int grain(int member) const { return grain_[member]; }

    /// First member of a grain; that of grain N is size().
    int first(int grain) const { return first_[grain]; }

    const std::vector<double>& radius() const { return radius_; }

    /// Centre of a member from its grain's centre [m].
    Vector<D> arm(int member, const Orientation<D>& orientation) const
    {
        return simple_ ? Vector<D>::Zero() : Vector<D>(orientation * arm_[member]);
    }

    /// Centres of all members [m].
    Vectors<D> positions(const Vectors<D>& grains, const Orientations<D>& orientations) const;

private:
    bool simple_ = true;
    std::vector<int> grain_, first_;
    std::vector<double> radius_;
    Vectors<D> arm_;   ///< in the body's frame; empty when simple
};

}  // namespace nscd
