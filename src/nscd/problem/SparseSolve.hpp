// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/problem/Solver.hpp"
#include "nscd/problem/SparseProblem.hpp"

namespace nscd
{

struct SolveLimits
{
    /// Largest natural map of a contact that is accepted [m/s].
    double tolerance = 1e-6;

    /// Work after which the solver gives up: solutions of single contacts over the number of contacts.
    int maxSweeps = 100000;
};

template <int D>
struct SparseSolution
{
    Vectors<D> r;            ///< impulses [N s]
    Residual residual;       ///< of r, found by residual()
    bool converged = false;  ///< residual.worst <= tolerance
    double sweeps = 0;       ///< work done: solutions of single contacts over the number of contacts
    double cpuSeconds = 0;   ///< of the calling process, from the first to the last instruction
};

/// Solve the problem from the guess r; an empty guess stands for zero.
///
/// sweeps    Non-linear Gauss-Seidel: exact solutions of one contact after the other.
/// queue     Only contacts whose velocity has changed by tolerance/(1 + mu), which bounds their natural map, since they
///           were last solved (Henry 2025, section 2.3, where single changes are compared with the tolerance, so that
///           many small ones go unnoticed).  A full residual tells which ones to begin with, and whether to go on
///           when none is left.
/// nesterov  A sweep starts from y = x + b (x - x_old) with Nesterov's sequence of b, which starts anew when
///           |sweep(y) - y| grows (Mazhar et al., ACM Trans. Graph. 34(3), 2015, doi:10.1145/2735627, for
///           gradient steps).  Coulomb's law is not that of a potential, so that this need not converge: when it
///           stops to make progress, plain sweeps follow.
///
/// A solver ends when residual() is within the tolerance, when nothing changes any more, when impulses grow beyond
/// all bounds, or after maxSweeps.  Throws std::invalid_argument for a tolerance <= 0, maxSweeps < 0, or a guess of
/// another length or with values that are not finite.
template <int D>
SparseSolution<D> solve(const SparseProblem<D>& problem, Solver solver, const SolveLimits& limits,
                        Vectors<D> guess = {});

extern template SparseSolution<2> solve<2>(const SparseProblem<2>&, Solver, const SolveLimits&, Vectors<2>);
extern template SparseSolution<3> solve<3>(const SparseProblem<3>&, Solver, const SolveLimits&, Vectors<3>);

}  // namespace nscd
