// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Random.hpp"
#include "nscd/base/Types.hpp"

#include <array>

namespace nscd
{

/// Discs or spheres that repel each other with a force equal to their overlap, in a box from the origin to 'size' whose
/// walls do the same, unless they are periodic: then 'size' must be at least six of the largest radii.  The smallest
/// grain has mass 1 and time follows from that.
template <int D>
class SoftGrains
{
public:
    SoftGrains(const Vector<D>& size, const std::array<bool, D>& periodic, std::vector<double> radii,
               Vectors<D> centres);

    /// Centres; along periodic axes within the box.
    const Vectors<D>& centres();

    /// Deepest overlap over the sum of the radii that overlap; a wall has none.
    double deepestOverlap() const { return deepest_; }

    /// Root of the mean over the grains of the squares of their overlaps, a pair's counted once [m].
    double typicalOverlap() const;

    /// Move downhill until no overlap is deeper than 'enough', or until they no longer give way.
    void quench(double enough);

    /// Agitate: random velocities that make overlaps of 'amplitude' [m], damped at 'rate' until a thousandth is left
    /// of them, or no overlap is deeper than 'enough'.
    void anneal(Random& random, double amplitude, double rate, double enough);

private:
    bool pairsAreOutdated() const;
    std::array<double, 3> period() const;
    void findPairs();
    void findForces();
    void addWalls(std::size_t i, int axis);
    void move(double dt, double kept = 1);
    Vector<D> separation(int i, int j) const;

    Vector<D> size_;
    std::array<bool, D> periodic_;
    std::vector<double> radius_;
    std::vector<double> inverseMass_;  ///< a large grain has many neighbours: of equal mass, it would need short steps
    Vectors<D> x_, v_, force_;
    double energy_ = 0, deepest_ = 0;

    double margin_;  ///< pairs with gaps below it are listed [m]
    std::vector<std::array<int, 2>> pairs_;
    Vectors<D> xOfPairs_;
};

}  // namespace nscd
