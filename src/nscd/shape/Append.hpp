// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/shape/Grains.hpp"

namespace nscd
{

/// Grains after others, which have the same clusters.
template <int D>
void append(Grains<D>& all, const Grains<D>& more)
{
    const auto add = [](auto& list, const auto& others) { list.insert(list.end(), others.begin(), others.end()); };
    add(all.id, more.id);
    add(all.position, more.position);
    add(all.velocity, more.velocity);
    add(all.orientation, more.orientation);
    add(all.spin, more.spin);
    add(all.shape, more.shape);
    add(all.radius, more.radius);
    add(all.mass, more.mass);
    add(all.material, more.material);
    add(all.temperature, more.temperature);
}

}  // namespace nscd
