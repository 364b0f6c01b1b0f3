// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace nscd
{

/// Throw std::invalid_argument with the parts written one after the other.
template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts)
{
    std::ostringstream message;
    (message << ... << parts);
    throw std::invalid_argument(message.str());
}

/// Finite and > 0; unlike a comparison, raises no floating-point exception for not-a-number.
inline bool isPositive(double value)
{
    return std::isfinite(value) && value > 0;
}

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

/// A radius in metres must be positive.
inline void checkRadius(double radius)
{
    if (!isPositive(radius))
    {
        refuse("radius ", radius, " m is not positive");
    }
}

}  // namespace nscd
