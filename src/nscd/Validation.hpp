// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/ContactDynamics.hpp"

#include <cmath>

namespace nscd
{

/// Throw std::invalid_argument naming what is wrong, and with which grain, wall or setting.
template <int D>
void validate(const Grains<D>& grains, const ContactTable& table);

void validate(const Walls<2>& walls, const ContactTable& table);
void validate(const Walls<3>& walls, const ContactTable& table);
void validate(const Settings& settings);
void validate(const ContactTable& table);

/// std::isfinite of all components; raises no floating-point exception.
template <class V>
bool isFinite(const V& v)
{
    for (int d = 0; d < v.size(); ++d)
    {
        if (!std::isfinite(v[d]))
        {
            return false;
        }
    }
    return true;
}

}  // namespace nscd
