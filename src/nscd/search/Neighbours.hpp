// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/search/CellGrid.hpp"

#include <cmath>

namespace nscd
{

/// Positions [m] moved by whole periods [m] into [0, period); 0 where an axis is not periodic.
template <int D>
Vectors<D> wrapped(Vectors<D> positions, const std::array<double, 3>& period)
{
    for (int d = 0; d < D; ++d)
    {
        if (period[d] > 0)
        {
            for (Vector<D>& x : positions)
            {
                x[d] -= period[d] * std::floor(x[d] / period[d]);
            }
        }
    }
    return positions;
}

/// Finds the discs or spheres near each other at a cost that is linear in their number, whatever their sizes: one grid
/// of cells for each range of sizes of a factor of two.
template <int D>
class Neighbours
{
public:
    /// Positions [m], within [0, period) along periodic axes, and radii [m]; those nearer than skin [m] are neighbours.
    Neighbours(const Vectors<D>& positions, const std::vector<double>& radii, double skin,
               const std::array<double, 3>& period);

    /// Call f(j, way to it [m]) for each neighbour j >= first of i, and for each periodic image of one, or of i.
    template <class F>
    void forImages(int i, int first, F&& f) const;

    /// Call f(j) for each neighbour j > first of i, other than i, and for each periodic image of one.
    template <class F>
    void forNear(int i, int first, F&& f) const
    {
        forImages(i, first + 1,
                  [&](int j, const Vector<D>&)
                  {
                      if (j != i)
                      {
                          f(j);
                      }
                  });
    }

    /// For each neighbour.
    template <class F>
    void forNear(int i, F&& f) const
    {
        forNear(i, -1, f);
    }

private:
    struct Seat
    {
        Vector<D> x;
        double radius;
        int index;
    };

    /// Those of one range of sizes, cell by cell.
    struct Level
    {
        double largest;
        CellGrid<D> grid;
        std::vector<Seat> seats;
    };

    static void addImages(std::vector<Seat>& seats, double reach, const std::array<double, 3>& period);

    const Vectors<D>& positions_;
    const std::vector<double>& radii_;
    double skin_;
    std::vector<Level> levels_;
};

template <int D>
template <class F>
void Neighbours<D>::forImages(int i, int first, F&& f) const
{
    const Vector<D>& x = positions_[i];
    const double reach = radii_[i] + skin_;
    for (const Level& level : levels_)
    {
        const Vector<D> corner = Vector<D>::Constant(reach + level.largest);
        level.grid.forCells(level.grid.coordinates(x - corner), level.grid.coordinates(x + corner),
                            [&](std::size_t cell)
                            {
                                for (int s = level.grid.begin()[cell]; s < level.grid.begin()[cell + 1]; ++s)
                                {
                                    const Seat& seat = level.seats[s];
                                    if (seat.index < first)
                                    {
                                        continue;
                                    }
                                    const Vector<D> way = seat.x - x;
                                    const double square = way.squaredNorm(), distance = reach + seat.radius;
                                    if (square < distance * distance && (seat.index != i || square > 0))
                                    {
                                        f(seat.index, way);
                                    }
                                }
                            });
    }
}

}  // namespace nscd
