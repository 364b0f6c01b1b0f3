// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Candidates.hpp"
#include "nscd/contact/Contact.hpp"

namespace nscd
{

/// Rounds of an edge colouring: pairs of one round have no block in common.  Greedy, in the order of the list.
std::vector<std::vector<std::pair<int, int>>> colourEdges(const std::vector<std::pair<int, int>>& edges, int blocks);

/// The order in which one pass goes through all groups of contacts, the same for every number of ranks: insides of
/// blocks first, then pairs of blocks round by round.  A pair is worked on by the rank of its lower block, to which
/// the rank of the higher block lends the velocities of the grains at the interface.
template <int D>
class Schedule
{
public:
    /// Collective.
    Schedule(const Candidates<D>& candidates, const Communicator& communicator);

    /// Call work(g) for each of this rank's groups, g an index into the candidates' groups.  Bodies of this rank's
    /// blocks are up to date afterwards.  Collective.
    template <class Work>
    void pass(std::vector<Body<D>>& bodies, Work&& work);

    /// Bring the bodies of all pairs that this rank lists up to date.  Collective.
    void refresh(std::vector<Body<D>>& bodies);

private:
    /// A pair of blocks that another rank works on with our grains, or that we work on with another rank's.
    struct Loan
    {
        int group;               ///< -1 when the other rank does the work
        int rank;                ///< the other one
        int tag;
        std::vector<int> grains;
        std::vector<Body<D>> bodies;
        MPI_Request sent = MPI_REQUEST_NULL;

        int bytes() const { return static_cast<int>(bodies.size() * sizeof(Body<D>)); }
    };

    struct Round
    {
        std::vector<int> local;
        std::vector<Loan> loans;
    };

    void send(Loan& loan, const std::vector<Body<D>>& bodies);
    void receive(Loan& loan, std::vector<Body<D>>& bodies);

    const Communicator* communicator_;
    std::vector<int> insides_;
    std::vector<Round> rounds_;
};

template <int D>
template <class Work>
void Schedule<D>::pass(std::vector<Body<D>>& bodies, Work&& work)
{
    for (const int group : insides_)
    {
        work(group);
    }
    for (Round& round : rounds_)
    {
        for (Loan& loan : round.loans)
        {
            if (loan.group < 0)
            {
                send(loan, bodies);
            }
        }
        for (const int group : round.local)
        {
            work(group);
        }
        for (Loan& loan : round.loans)
        {
            if (loan.group >= 0)
            {
                receive(loan, bodies);
                work(loan.group);
                send(loan, bodies);
            }
        }
        for (Loan& loan : round.loans)
        {
            if (loan.group < 0)
            {
                receive(loan, bodies);
            }
            MPI_Wait(&loan.sent, MPI_STATUS_IGNORE);
        }
    }
}

}  // namespace nscd
