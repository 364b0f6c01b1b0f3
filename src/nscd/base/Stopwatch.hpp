// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>

namespace nscd
{

/// Wall clock.
class Stopwatch
{
public:
    /// Time since the start or the last restart [s].
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    double restart()
    {
        const double elapsed = seconds();
        start_ = Clock::now();
        return elapsed;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace nscd
