// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/problem/SparseProblem.hpp"

#include <optional>
#include <string>
#include <variant>

/// Contact problems in the 'local' form of FCLIB, the exchange format for frictional contact problems in HDF5:
/// V. Acary, M. Bremond, T. Koziara, F. Perignon, FCLIB: a collection of discrete 3D frictional contact problems,
/// INRIA RT-0444 (2014), hal-00945820.
///
///     fclib_local/spacedim             2 or 3
///     fclib_local/W/{m,n,nzmax,nz}     extent of W, size of x, and its form:
///                                      nz >= 0 triplets in any order, rows i, columns p (the reverse of what
///                                      FCLIB's header says, as in CSparse), nz of them;
///                                      -1 columns one after the other, i rows; -2 rows, i columns; column or row k
///                                      from p[k] up to p[k+1]
///     fclib_local/W/{p,i,x}
///     fclib_local/vectors/{q,mu}       contact after contact, normal component first
///     guesses/number_of_guesses        optional; guesses/1/{u,r} ...
///     solution/{u,r}                   optional
///
/// Integers have 32 bits.  Errors are std::runtime_error with the name of the file and of what in it is wrong.
namespace nscd
{

/// How W is stored.
enum class FclibStorage
{
    triplets,
    columns,
    rows
};

template <int D>
struct FclibSolution
{
    Vectors<D> r;  ///< impulses [N s]
    Vectors<D> u;  ///< relative velocities [m/s]
};

template <int D>
struct FclibProblem
{
    SparseProblem<D> problem;
    std::vector<FclibSolution<D>> guesses;
    std::optional<FclibSolution<D>> solution;
};

/// Problems with equality constraints, and the 'global' form, in which W is not assembled, are refused.
std::variant<FclibProblem<2>, FclibProblem<3>> readFclib(const std::string& file);

/// An existing file is overwritten.
template <int D>
void writeFclib(const std::string& file, const FclibProblem<D>& problem, FclibStorage storage = FclibStorage::rows);

/// Write a copy of 'source' with this solution, and no other, to 'target', which may be the same file.  It appears as
/// a whole or not at all.
template <int D>
void writeFclibSolution(const std::string& source, const std::string& target, const FclibSolution<D>& solution);

}  // namespace nscd
