// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace nscd
{

/// Points sorted into cubic cells by counting.  Cell coordinates wrap around, so that memory stays of the order of
/// the number of points even when one has strayed far away; who looks into a cell must check distances anyway.
template <int D>
class CellGrid
{
public:
    using Coordinates = std::array<std::int64_t, D>;

    /// Cells of side 'side' > 0 [m].
    CellGrid(const Vectors<D>& points, double side);

    std::size_t cells() const { return begin_.size() - 1; }

    /// Coordinates before wrapping, those of the lowest point being 0.
    Coordinates coordinates(const Vector<D>& x) const;

    /// Number of a cell, x fastest.
    std::size_t cell(const Coordinates& c) const;

    /// Points in the order of cells, and where each cell's begin in it.
    const std::vector<int>& members() const { return members_; }
    const std::vector<int>& begin() const { return begin_; }

    /// Call f(cell) once for each of the cells whose coordinates lie in [first, last].
    template <class F>
    void forCells(Coordinates first, Coordinates last, F&& f) const;

    /// Coordinates of the highest point.
    const Coordinates& top() const { return top_; }

private:
    Vector<D> origin_ = Vector<D>::Zero();
    double inverseSide_;
    std::array<std::int64_t, D> cells_;   ///< along each axis: a power of two, at least 4
    Coordinates top_{};
    std::vector<int> members_, begin_;
};

template <int D>
template <class F>
void CellGrid<D>::forCells(Coordinates first, Coordinates last, F&& f) const
{
    for (int d = 0; d < D; ++d)
    {
        last[d] = std::min(last[d], first[d] + cells_[d] - 1);
    }
    for (Coordinates c = first; c[D - 1] <= last[D - 1];)
    {
        if (c[0] <= last[0])
        {
            f(cell(c));
            ++c[0];
        }
        for (int d = 0; d + 1 < D && c[d] > last[d]; ++d)
        {
            c[d] = first[d];
            ++c[d + 1];
        }
    }
}

}  // namespace nscd
