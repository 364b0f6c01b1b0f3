// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/mesh/CellShape.hpp"

#include <vector>

namespace overlap
{

/// Finds the cells whose bounds meet a ball, in a time that grows with their number and the logarithm of all, whatever
/// the sizes of ball and cells and wherever the cells are.
class CellTree
{
public:
    /// Made of the bounds of the cells, in a time of N log N.
    void build(const std::vector<CellShape>& cells);

    /// The same cells with other bounds; the tree stays as good as the cells stay neighbours.
    void refit(const std::vector<CellShape>& cells);

    /// Calls inside(cell) for cells whose bounds are within the ball, meets(cell) for the others whose bounds meet it,
    /// until one returns false.  The order depends on the tree alone.
    template <class Inside, class Meets>
    void forCells(const Point3& centre, double radius, Inside&& inside, Meets&& meets) const;

private:
    /// Depth first: the first child follows its parent, the second one the last descendant of the first.
    struct Node
    {
        Point3 low, high;
        std::uint32_t begin, end;  ///< of its cells
        std::uint32_t next;        ///< first node after its descendants, its own successor if it is a leaf
    };

    void grow(const std::vector<CellShape>& cells, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> nodes_;
    std::vector<int> cells_;
    std::vector<Point3> low_, high_;  ///< bounds of cells_
};

template <class Inside, class Meets>
void CellTree::forCells(const Point3& centre, double radius, Inside&& inside, Meets&& meets) const
{
    const double reach2 = radius * radius;
    const auto nearest2 = [&](const Point3& low, const Point3& high)
    { return (centre.cwiseMax(low).cwiseMin(high) - centre).squaredNorm(); };
    const auto farthest2 = [&](const Point3& low, const Point3& high)
    { return (centre - low).cwiseAbs().cwiseMax((high - centre).cwiseAbs()).squaredNorm(); };

    for (std::uint32_t n = 0; n < nodes_.size();)
    {
        const Node& node = nodes_[n];
        if (nearest2(node.low, node.high) >= reach2)
        {
            n = node.next;
        }
        else if (farthest2(node.low, node.high) <= reach2)
        {
            for (std::uint32_t k = node.begin; k < node.end; ++k)
            {
                if (!inside(cells_[k])) return;
            }
            n = node.next;
        }
        else
        {
            if (node.next == n + 1)
            {
                for (std::uint32_t k = node.begin; k < node.end; ++k)
                {
                    if (nearest2(low_[k], high_[k]) >= reach2) continue;
                    const bool isInside = farthest2(low_[k], high_[k]) <= reach2;
                    if (!(isInside ? inside(cells_[k]) : meets(cells_[k]))) return;
                }
            }
            ++n;
        }
    }
}

}  // namespace overlap
