// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/contact/Schedule.hpp"

namespace nscd
{

std::vector<std::vector<std::pair<int, int>>> colourEdges(const std::vector<std::pair<int, int>>& edges, int blocks)
{
    std::vector<std::vector<std::pair<int, int>>> rounds;
    std::vector<std::vector<char>> busy;
    for (const auto& edge : edges)
    {
        std::size_t round = 0;
        while (round < rounds.size() && (busy[round][edge.first] || busy[round][edge.second]))
        {
            ++round;
        }
        if (round == rounds.size())
        {
            rounds.emplace_back();
            busy.emplace_back(blocks, 0);
        }
        rounds[round].push_back(edge);
        busy[round][edge.first] = busy[round][edge.second] = 1;
    }
    return rounds;
}

template <int D>
Schedule<D>::Schedule(const Candidates<D>& candidates, const Communicator& communicator)
    : communicator_(&communicator)
{
    const int blocks = candidates.blocks();
    std::vector<int> groupOf(static_cast<std::size_t>(blocks) * blocks, -1);
    std::vector<int> mine;   // of each pair of blocks: lower, higher, number of borrowed grains, the grains
    std::vector<std::vector<int>> borrowed(candidates.groups().size());
    for (std::size_t g = 0; g < candidates.groups().size(); ++g)
    {
        const Group& group = candidates.groups()[g];
        if (group.first == group.second)
        {
            insides_.push_back(static_cast<int>(g));
            continue;
        }
        groupOf[group.first * blocks + group.second] = static_cast<int>(g);
        std::vector<int>& grains = borrowed[g];
        for (std::size_t p = group.begin; p < group.end; ++p)
        {
            grains.push_back(candidates.secondBody(candidates.pairs()[p]));
        }
        std::sort(grains.begin(), grains.end());
        grains.erase(std::unique(grains.begin(), grains.end()), grains.end());
        mine.insert(mine.end(), {group.first, group.second, static_cast<int>(grains.size())});
        mine.insert(mine.end(), grains.begin(), grains.end());
    }

    const std::vector<int> all = communicator.gather(mine);
    std::vector<std::pair<int, int>> edges;
    std::vector<std::vector<int>> grainsOf(groupOf.size());
    for (std::size_t k = 0; k < all.size(); k += 3 + all[k + 2])
    {
        edges.emplace_back(all[k], all[k + 1]);
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(k) + 3;
        grainsOf[all[k] * blocks + all[k + 1]].assign(first, first + all[k + 2]);
    }

    const int self = communicator.rank();
    for (const auto& edgesOfRound : colourEdges(edges, blocks))
    {
        Round& round = rounds_.emplace_back();
        for (const auto& [lower, higher] : edgesOfRound)
        {
            const int key = lower * blocks + higher;
            const int worker = candidates.rankOf(lower);
            const int lender = candidates.rankOf(higher);
            if (worker == self && lender == self)
            {
                round.local.push_back(groupOf[key]);
            }
            else if (worker == self || lender == self)
            {
                round.loans.push_back({groupOf[key], worker == self ? lender : worker, key, grainsOf[key], {}});
            }
        }
    }
}

template <int D>
void Schedule<D>::refresh(std::vector<Body<D>>& bodies)
{
    const auto forLoans = [&](bool ours, auto&& f)
    {
        for (Round& round : rounds_)
        {
            for (Loan& loan : round.loans)
            {
                if ((loan.group < 0) == ours)
                {
                    f(loan);
                }
            }
        }
    };
    forLoans(true, [&](Loan& loan) { send(loan, bodies); });
    forLoans(false, [&](Loan& loan) { receive(loan, bodies); });
    forLoans(true, [](Loan& loan) { MPI_Wait(&loan.sent, MPI_STATUS_IGNORE); });
}

template class Schedule<2>;
template class Schedule<3>;

}  // namespace nscd
