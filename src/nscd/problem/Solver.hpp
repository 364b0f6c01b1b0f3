// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Check.hpp"

#include <string>

namespace nscd
{

/// How the impulses of all contacts are found; the answer is the same.
enum class Solver
{
    sweeps,   ///< plain non-linear Gauss-Seidel: all contacts, one after the other, again and again
    queue,    ///< only contacts whose grains have changed by more than the tolerance since they were last solved
    nesterov  ///< sweeps with momentum, restarted when they go astray, and plain sweeps to finish
};

/// Throws std::invalid_argument, with the valid names, for any other.
inline Solver solverOfName(const std::string& name)
{
    if (name == "sweeps")
    {
        return Solver::sweeps;
    }
    if (name == "queue")
    {
        return Solver::queue;
    }
    if (name == "nesterov")
    {
        return Solver::nesterov;
    }
    refuse("unknown solver '", name, "': sweeps, queue and nesterov are known");
}

}  // namespace nscd
