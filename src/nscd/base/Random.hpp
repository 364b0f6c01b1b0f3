// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <random>

namespace nscd
{

/// Uniform random numbers, the same for a seed on every platform (the standard's distributions are not).
class Random
{
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [lower, upper).
    double uniform(double lower, double upper)
    {
        ++drawn_;
        return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }

    /// How many numbers there have been.
    std::uint64_t drawn() const { return drawn_; }

    /// Go on as if there had been so many more.
    void skip(std::uint64_t numbers)
    {
        engine_.discard(numbers);
        drawn_ += numbers;
    }

private:
    std::mt19937_64 engine_;
    std::uint64_t drawn_ = 0;
};

}  // namespace nscd
