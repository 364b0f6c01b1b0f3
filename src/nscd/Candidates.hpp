// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/CellGrid.hpp"
#include "nscd/Communicator.hpp"
#include "nscd/Grains.hpp"
#include "nscd/WallContact.hpp"

namespace nscd
{

/// Two grains in solver order, first < second, or a grain and wall ~second where second < 0.
struct Pair
{
    int first, second;
};

/// Pairs [begin, end) inside block 'first' (second == first; the block's walls included) or between two blocks,
/// first < second.
struct Group
{
    int first, second;
    std::size_t begin, end;
};

/// The grains cut into spatial blocks and sorted for locality, and the pairs that are worth watching: those nearer
/// than 'skin' at the positions the list was made for.  A function of these positions, the radii and the skin
/// alone.  Blocks are dealt to the ranks; a rank lists the pairs whose lower block is its own.
template <int D>
class Candidates
{
public:
    Candidates() = default;
    Candidates(const Vectors<D>& positions, const std::vector<double>& radii, const WallContact<D>& walls,
               double skin, int blocks, const Communicator& communicator);

    /// Can no unlisted pair come into contact before the grains have gone further than these displacements?
    bool cover(double largestDisplacement) const { return !order_.empty() && 2 * largestDisplacement <= skin_; }

    double skin() const { return skin_; }
    const Vectors<D>& positions() const { return positions_; }

    /// User's number of the grain at each place of solver order.
    const std::vector<int>& order() const { return order_; }

    /// First grain (solver order) of every rank, and the number of grains at the end.
    const std::vector<std::size_t>& rankBegin() const { return rankBegin_; }

    int blocks() const { return static_cast<int>(blockBegin_.size()) - 1; }
    int rankOf(int block) const { return blockRank_[block]; }

    /// This rank's groups: of each of its blocks the block itself, then its pairs with higher blocks.
    const std::vector<Group>& groups() const { return groups_; }
    const std::vector<Pair>& pairs() const { return pairs_; }

private:
    struct Seat;

    void sort(const CellGrid<D>& grid, int blocks, const Communicator& communicator);
    void detect(const CellGrid<D>& grid, const std::vector<double>& radii, const WallContact<D>& walls,
                int rank);
    void append(int first, int second, const std::vector<Pair>& pairs);

    double skin_ = 0;
    Vectors<D> positions_;
    std::vector<int> order_, place_, blockOf_;
    std::vector<int> blockBegin_, blockRank_;
    std::vector<std::size_t> rankBegin_;
    std::vector<Group> groups_;
    std::vector<Pair> pairs_;
};

}  // namespace nscd
