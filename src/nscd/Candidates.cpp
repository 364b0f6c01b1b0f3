// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/Candidates.hpp"

#include "nscd/Bisection.hpp"

namespace nscd
{

namespace
{

/// Consecutive pairs of one stream share grains and wait for each other's result; pairs of far apart streams do
/// not, so that the processor can work on several at once.
constexpr std::size_t streams = 4;

}  // namespace

template <int D>
struct Candidates<D>::Seat
{
    Vector<D> x;
    double radius;
    int place;
};

template <int D>
Candidates<D>::Candidates(const Vectors<D>& positions, const std::vector<double>& radii, const WallContact<D>& walls,
                          double skin, int blocks, const Communicator& communicator)
    : skin_(skin), positions_(positions)
{
    const double largest = radii.empty() ? 1.0 : *std::max_element(radii.begin(), radii.end());
    const CellGrid<D> grid(positions, 2 * largest + skin);
    sort(grid, blocks, communicator);
    detect(grid, radii, walls, communicator.rank());
}

template <int D>
void Candidates<D>::sort(const CellGrid<D>& grid, int blocks, const Communicator& communicator)
{
    const std::size_t n = positions_.size();
    const std::vector<int> block = bisect<D>(positions_, blocks);

    blockBegin_.assign(blocks + 1, 0);
    for (const int b : block)
    {
        ++blockBegin_[b + 1];
    }
    for (int b = 0; b < blocks; ++b)
    {
        blockBegin_[b + 1] += blockBegin_[b];
    }

    order_.resize(n);
    place_.resize(n);
    blockOf_.resize(n);
    std::vector<int> next(blockBegin_.begin(), blockBegin_.end() - 1);
    for (const int grain : grid.members())
    {
        const int place = next[block[grain]]++;
        order_[place] = grain;
        place_[grain] = place;
        blockOf_[place] = block[grain];
    }

    const int ranks = communicator.size();
    blockRank_.resize(blocks);
    rankBegin_.assign(ranks + 1, n);
    for (int b = blocks - 1; b >= 0; --b)
    {
        blockRank_[b] = static_cast<int>(static_cast<std::int64_t>(b) * ranks / blocks);
        std::fill(rankBegin_.begin(), rankBegin_.begin() + blockRank_[b] + 1, blockBegin_[b]);
    }
    std::fill(rankBegin_.begin(), rankBegin_.begin() + blockRank_[0] + 1, 0);
}

template <int D>
void Candidates<D>::detect(const CellGrid<D>& grid, const std::vector<double>& radii, const WallContact<D>& walls,
                           int rank)
{
    std::vector<Seat> seats;
    seats.reserve(order_.size());
    for (const int grain : grid.members())
    {
        seats.push_back({positions_[grain], radii[grain], place_[grain]});
    }

    const int blocks = this->blocks();
    std::vector<std::vector<Pair>> found(blocks);
    for (int block = 0; block < blocks; ++block)
    {
        if (blockRank_[block] != rank)
        {
            continue;
        }
        for (int i = blockBegin_[block]; i < blockBegin_[block + 1]; ++i)
        {
            const Vector<D>& x = positions_[order_[i]];
            const double reach = radii[order_[i]] + skin_;
            const auto centre = grid.coordinates(x);
            auto first = centre;
            auto last = centre;
            for (int d = 0; d < D; ++d)
            {
                --first[d];
                ++last[d];
            }
            grid.forCells(first, last,
                          [&](std::size_t cell)
                          {
                              for (int s = grid.begin()[cell]; s < grid.begin()[cell + 1]; ++s)
                              {
                                  const Seat& other = seats[s];
                                  const double distance = reach + other.radius;
                                  if (other.place > i && (other.x - x).squaredNorm() < distance * distance)
                                  {
                                      found[blockOf_[other.place]].push_back({i, other.place});
                                  }
                              }
                          });
            walls.forNear(x, reach, [&](int wall) { found[block].push_back({i, ~wall}); });
        }
        for (int other = block; other < blocks; ++other)
        {
            append(block, other, found[other]);
            found[other].clear();
        }
    }
}

template <int D>
void Candidates<D>::append(int first, int second, const std::vector<Pair>& pairs)
{
    if (pairs.empty() && first != second)
    {
        return;
    }
    const std::size_t begin = pairs_.size();
    const std::size_t length = (pairs.size() + streams - 1) / streams;
    for (std::size_t k = 0; k < length; ++k)
    {
        for (std::size_t s = k; s < pairs.size(); s += length)
        {
            pairs_.push_back(pairs[s]);
        }
    }
    groups_.push_back({first, second, begin, pairs_.size()});
}

template class Candidates<2>;
template class Candidates<3>;

}  // namespace nscd
