// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/mesh/CellTree.hpp"

#include <algorithm>
#include <numeric>

namespace overlap
{

namespace
{

constexpr std::uint32_t leafSize = 4;

}  // namespace

void CellTree::build(const std::vector<CellShape>& cells)
{
    cells_.resize(cells.size());
    std::iota(cells_.begin(), cells_.end(), 0);
    nodes_.clear();
    if (!cells.empty()) grow(cells, 0, static_cast<std::uint32_t>(cells.size()));
    refit(cells);
}

void CellTree::grow(const std::vector<CellShape>& cells, std::uint32_t begin, std::uint32_t end)
{
    const std::size_t self = nodes_.size();
    nodes_.push_back({Point3::Zero(), Point3::Zero(), begin, end, 0});
    if (end - begin > leafSize)
    {
        Point3 low = cells[cells_[begin]].centroid, high = low;
        for (std::uint32_t k = begin; k < end; ++k)
        {
            low = low.cwiseMin(cells[cells_[k]].centroid);
            high = high.cwiseMax(cells[cells_[k]].centroid);
        }
        int axis;
        (high - low).maxCoeff(&axis);
        const auto before = [&](int a, int b)
        {
            const double xa = cells[a].centroid[axis], xb = cells[b].centroid[axis];
            return xa < xb || (xa == xb && a < b);
        };
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(cells_.begin() + begin, cells_.begin() + middle, cells_.begin() + end, before);
        grow(cells, begin, middle);
        grow(cells, middle, end);
    }
    nodes_[self].next = static_cast<std::uint32_t>(nodes_.size());
}

void CellTree::refit(const std::vector<CellShape>& cells)
{
    low_.resize(cells_.size());
    high_.resize(cells_.size());
    for (std::size_t k = 0; k < cells_.size(); ++k)
    {
        low_[k] = cells[cells_[k]].low;
        high_[k] = cells[cells_[k]].high;
    }
    for (std::size_t n = nodes_.size(); n-- > 0;)
    {
        Node& node = nodes_[n];
        if (node.next == n + 1)
        {
            node.low = low_[node.begin];
            node.high = high_[node.begin];
            for (std::uint32_t k = node.begin; k < node.end; ++k)
            {
                node.low = node.low.cwiseMin(low_[k]);
                node.high = node.high.cwiseMax(high_[k]);
            }
        }
        else
        {
            const Node &first = nodes_[n + 1], &second = nodes_[first.next];
            node.low = first.low.cwiseMin(second.low);
            node.high = first.high.cwiseMax(second.high);
        }
    }
}

}  // namespace overlap
