// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/contact/Candidates.hpp"

#include "nscd/search/Bisection.hpp"
#include "nscd/search/Neighbours.hpp"

#include <numeric>

namespace nscd
{

namespace
{

/// Consecutive pairs of one stream share grains and wait for each other's result; pairs of far apart streams do
/// not, so that the processor can work on several at once.
constexpr std::size_t streams = 4;

/// Finding and measuring a pair of a grain and a wall, over that of two grains.
constexpr double workOfWall = 8;

double mean(const std::vector<double>& values)
{
    return values.empty() ? 1.0 : std::accumulate(values.begin(), values.end(), 0.0) / values.size();
}

}  // namespace

std::vector<int> deal(const std::vector<double>& work, int ranks)
{
    const double all = std::accumulate(work.begin(), work.end(), 0.0);
    if (all == 0)
    {
        return deal(std::vector<double>(work.size(), 1.0), ranks);
    }
    std::vector<int> rank;
    double before = 0;
    for (const double w : work)
    {
        rank.push_back(std::min(ranks - 1, static_cast<int>((before + w / 2) / all * ranks)));
        before += w;
    }
    return rank;
}

template <int D>
Candidates<D>::Candidates(const Watch<D>& watch, const Vectors<D>& positions, const Orientations<D>& orientations,
                          const Communicator& communicator)
    : reach_(watch.reach), positions_(positions), orientations_(orientations)
{
    const Vectors<D> members = wrapped<D>(watch.members.positions(positions, orientations), watch.period);
    sort(watch, members, wrapped<D>(positions, watch.period), communicator);

    Vectors<D> x(members.size());
    std::vector<double> reaching(members.size());   // radius and reach
    for (std::size_t m = 0; m < members.size(); ++m)
    {
        x[memberPlace_[m]] = members[m];
        reaching[memberPlace_[m]] = watch.members.radius()[m] + reach_.ofGrain[watch.members.grain(m)];
    }
    const Neighbours<D> neighbours(x, reaching, 0, watch.period);
    const int grainBlocks = static_cast<int>(memberBegin_.size()) - 1;
    std::vector<std::vector<Pair>> found(grainBlocks + 1);
    work_.assign(grainBlocks, 0);
    const bool periodic = *std::max_element(watch.period.begin(), watch.period.end()) > 0;
    const auto isListed = [periodic](const std::vector<Pair>& pairs, int i, int j)   // by another image
    {
        bool listed = false;
        for (auto p = pairs.rbegin(); periodic && !listed && p != pairs.rend() && p->first == i; ++p)
        {
            listed = p->second == j;
        }
        return listed;
    };
    for (int block = 0; block < grainBlocks; ++block)
    {
        if (blockRank_[block] != communicator.rank())
        {
            continue;
        }
        for (int i = memberBegin_[block]; i < memberBegin_[block + 1]; ++i)
        {
            neighbours.forNear(i, i,
                               [&](int j)
                               {
                                   std::vector<Pair>& pairs = found[blockOf_[j]];
                                   if (body_[i] != body_[j] && !isListed(pairs, i, j))
                                   {
                                       pairs.push_back({i, j});
                                   }
                               });
            watch.walls.forNear(x[i], reaching[i] + reach_.ofWalls,
                                [&](int wall)
                                { found[watch.freeBodyOfWall[wall] < 0 ? block : grainBlocks].push_back({i, ~wall}); });
        }
        for (int other = block; other <= grainBlocks; ++other)
        {
            for (const Pair& pair : found[other])
            {
                work_[block] += pair.second < 0 ? workOfWall : 1;
            }
            append(block, other, found[other]);
            found[other].clear();
        }
    }
    communicator.sum(work_);
}

template <int D>
void Candidates<D>::sort(const Watch<D>& watch, const Vectors<D>& members, const Vectors<D>& grains,
                         const Communicator& communicator)
{
    const int n = static_cast<int>(grains.size());
    const std::vector<int> block = bisect<D>(grains, watch.blocks);
    grainBegin_.assign(watch.blocks + 1, 0);
    for (const int b : block)
    {
        ++grainBegin_[b + 1];
    }
    std::partial_sum(grainBegin_.begin(), grainBegin_.end(), grainBegin_.begin());

    order_.resize(n);
    place_.resize(n);
    std::vector<int> next(grainBegin_.begin(), grainBegin_.end() - 1);
    const CellGrid<D> grid(members, 2 * (mean(watch.members.radius()) + mean(reach_.ofGrain)));
    for (const int member : grid.members())
    {
        const int grain = watch.members.grain(member);
        if (member == watch.members.first(grain))
        {
            place_[grain] = next[block[grain]]++;
            order_[place_[grain]] = grain;
        }
    }

    memberPlace_.resize(members.size());
    memberBegin_.assign(1, 0);
    for (int place = 0; place < n; ++place)
    {
        const int grain = order_[place];
        memberBegin_.resize(block[grain] + 1, static_cast<int>(memberOrder_.size()));
        for (int m = watch.members.first(grain); m < watch.members.first(grain + 1); ++m)
        {
            memberPlace_[m] = static_cast<int>(memberOrder_.size());
            memberOrder_.push_back(m);
            body_.push_back(place);
            blockOf_.push_back(block[grain]);
        }
    }
    memberBegin_.resize(watch.blocks + 1, static_cast<int>(memberOrder_.size()));

    fixedBody_ = n + watch.freeBodies;
    for (const int body : watch.freeBodyOfWall)
    {
        wallBody_.push_back(body < 0 ? fixedBody_ : n + body);
    }
    dealBlocks(watch, communicator.size());
}

template <int D>
void Candidates<D>::dealBlocks(const Watch<D>& watch, int ranks)
{
    blockRank_ = deal(watch.work.empty() ? std::vector<double>(watch.blocks, 1.0) : watch.work, ranks);
    rankBegin_.assign(ranks + 1, fixedBody_);
    for (int b = watch.blocks - 1; b >= 0; --b)
    {
        std::fill(rankBegin_.begin(), rankBegin_.begin() + blockRank_[b] + 1, grainBegin_[b]);
    }
    std::fill(rankBegin_.begin(), rankBegin_.begin() + blockRank_[0] + 1, 0);
    if (watch.freeBodies > 0)
    {
        blockRank_.push_back(blockRank_.back());
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
