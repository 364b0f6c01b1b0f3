// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Communicator.hpp"
#include "nscd/shape/Members.hpp"
#include "nscd/walls/WallContact.hpp"

namespace nscd
{

/// Two members in solver order, first < second, or a member and wall ~second where second < 0.
struct Pair
{
    int first, second;
};

/// Pairs [begin, end) inside block 'first' (second == first; the block's walls included) or between two blocks,
/// first < second.  The last block is that of the free wall bodies, if there are any.
struct Group
{
    int first, second;
    std::size_t begin, end;
};

/// How far grains and walls may go until pairs must be listed anew [m].
struct Reach
{
    std::vector<double> ofGrain;
    double ofWalls = 0;
};

/// What there is to be watched, and how closely.
template <int D>
struct Watch
{
    const Members<D>& members;
    const WallContact<D>& walls;
    const std::vector<int>& freeBodyOfWall;   ///< index of the free body each wall belongs to; -1 for none
    int freeBodies;
    const Reach& reach;
    int blocks;
    std::array<double, 3> period;             ///< [m], 0 where not periodic
    const std::vector<double>& work;          ///< of each block in the list before; empty for none
};

/// Rank of each block: ranks in turn have blocks that follow each other, by equal shares of the work to a block's half.
/// Without any work they have equal numbers of blocks.
std::vector<int> deal(const std::vector<double>& work, int ranks);

/// The grains cut into spatial blocks and sorted for locality, and the pairs of members that are worth watching: those
/// whose gap is less than the sum of their reaches at the positions the list was made for.  A function of these
/// positions, the radii and the reaches alone.  Blocks are dealt to the ranks so that these have equal shares of the
/// work; a rank lists the pairs whose lower block is its own.
template <int D>
class Candidates
{
public:
    Candidates() = default;
    Candidates(const Watch<D>& watch, const Vectors<D>& positions, const Orientations<D>& orientations,
               const Communicator& communicator);

    /// As long as no grain and no wall goes further, no unlisted pair comes into contact.
    const Reach& reach() const { return reach_; }

    const Vectors<D>& positions() const { return positions_; }
    const Orientations<D>& orientations() const { return orientations_; }

    /// User's number of the grain at each place of solver order, and of the member.
    const std::vector<int>& order() const { return order_; }
    const std::vector<int>& memberOrder() const { return memberOrder_; }

    /// Place of each of the user's grains.
    const std::vector<int>& place() const { return place_; }

    /// Place of the grain that a member belongs to.
    int body(int member) const { return body_[member]; }

    /// Place of a pair's second body; walls that are not free are the one body after all others.
    int secondBody(const Pair& pair) const
    {
        return pair.second >= 0 ? body_[pair.second] : wallBody_[~pair.second];
    }

    /// Number of grains and free wall bodies: the place of the fixed body.
    int fixedBody() const { return fixedBody_; }

    /// First body of every rank, and the number of bodies at the end.  The last rank has the free wall bodies.
    const std::vector<std::size_t>& rankBegin() const { return rankBegin_; }

    /// Blocks of grains and, if there are free wall bodies, one more.
    int blocks() const { return static_cast<int>(blockRank_.size()); }
    int rankOf(int block) const { return blockRank_[block]; }

    /// Work that the pairs of each block of grains are, in pairs of two grains; all ranks.
    const std::vector<double>& work() const { return work_; }

    /// This rank's groups: of each of its blocks the block itself, then its pairs with higher blocks.
    const std::vector<Group>& groups() const { return groups_; }
    const std::vector<Pair>& pairs() const { return pairs_; }

private:
    void sort(const Watch<D>& watch, const Vectors<D>& members, const Vectors<D>& grains,
              const Communicator& communicator);
    void dealBlocks(const Watch<D>& watch, int ranks);
    void append(int first, int second, const std::vector<Pair>& pairs);

    Reach reach_;
    Vectors<D> positions_;
    Orientations<D> orientations_;
    std::vector<int> order_, place_, memberOrder_, memberPlace_, body_, wallBody_;
    std::vector<int> blockOf_;   ///< of members, by place
    std::vector<int> grainBegin_, memberBegin_, blockRank_;
    std::vector<std::size_t> rankBegin_;
    std::vector<double> work_;
    int fixedBody_ = 0;
    std::vector<Group> groups_;
    std::vector<Pair> pairs_;
};

}  // namespace nscd
