// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/search/CellGrid.hpp"

namespace nscd
{

namespace
{

/// Powers of two along the axes that cover the extent [cells], but no more than about 'limit' cells in all.
template <int D>
std::array<std::int64_t, D> gridSize(const std::array<std::int64_t, D>& extent, std::int64_t limit)
{
    std::array<std::int64_t, D> n;
    n.fill(4);
    std::int64_t total = std::int64_t(1) << 2 * D;
    for (bool grown = true; grown;)
    {
        grown = false;
        for (int d = 0; d < D; ++d)
        {
            if (n[d] < extent[d] && 2 * total <= limit)
            {
                n[d] *= 2;
                total *= 2;
                grown = true;
            }
        }
    }
    return n;
}

}  // namespace

template <int D>
CellGrid<D>::CellGrid(const Vectors<D>& points, double side)
    : inverseSide_(1 / side), members_(points.size())
{
    if (!points.empty())
    {
        Vector<D> upper = origin_ = points[0];
        for (const Vector<D>& x : points)
        {
            origin_ = origin_.cwiseMin(x);
            upper = upper.cwiseMax(x);
        }
        top_ = coordinates(upper);
    }
    Coordinates extent = top_;
    std::for_each(extent.begin(), extent.end(), [](std::int64_t& n) { ++n; });
    cells_ = gridSize<D>(extent, std::max<std::int64_t>(256, 8 * points.size()));

    std::size_t total = 1;
    for (const std::int64_t n : cells_)
    {
        total *= n;
    }
    begin_.assign(total + 1, 0);
    std::vector<int> home(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
        home[p] = static_cast<int>(cell(coordinates(points[p])));
        ++begin_[home[p] + 1];
    }
    for (std::size_t c = 0; c < total; ++c)
    {
        begin_[c + 1] += begin_[c];
    }
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t p = 0; p < points.size(); ++p)
    {
        members_[next[home[p]]++] = static_cast<int>(p);
    }
}

template <int D>
auto CellGrid<D>::coordinates(const Vector<D>& x) const -> Coordinates
{
    constexpr double farthest = 1e15;   // a stray point beyond shares a cell with others: no harm
    Coordinates c;
    for (int d = 0; d < D; ++d)
    {
        const double cells = std::min(farthest, std::max(-farthest, (x[d] - origin_[d]) * inverseSide_));
        c[d] = static_cast<std::int64_t>(cells);
        c[d] -= cells < static_cast<double>(c[d]);   // floor
    }
    return c;
}

template <int D>
std::size_t CellGrid<D>::cell(const Coordinates& c) const
{
    std::size_t index = 0;
    for (int d = D - 1; d >= 0; --d)
    {
        index = index * cells_[d] + (c[d] & (cells_[d] - 1));
    }
    return index;
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace nscd
