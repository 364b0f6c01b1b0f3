// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Candidates.hpp"
#include "nscd/contact/Contact.hpp"

#include <cstring>

namespace nscd
{

/// Rounds of an edge colouring: pairs of one round have no block in common.  Greedy, in the order of the list.
std::vector<std::vector<std::pair<int, int>>> colourEdges(const std::vector<std::pair<int, int>>& edges, int blocks);

/// The order in which one pass goes through all groups of contacts, the same for every number of ranks: insides of
/// blocks first, then pairs of blocks round by round.  A pair is worked on by the rank of its lower block, to which
/// the rank of the higher block lends what is known of the grains at the interface: one record per body, of any type
/// that may be copied byte by byte.
template <int D>
class Schedule
{
public:
    /// Collective.
    Schedule(const Candidates<D>& candidates, const Communicator& communicator);

    /// Call work(g) for each of this rank's groups, g an index into the candidates' groups.  Bodies of this rank's
    /// blocks are up to date afterwards.  Collective.
    template <class Record, class Work>
    void pass(std::vector<Record>& bodies, Work&& work);

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
        std::vector<char> buffer;
        MPI_Request sent = MPI_REQUEST_NULL;

        int bytes() const { return static_cast<int>(buffer.size()); }
    };

    struct Round
    {
        std::vector<int> local;
        std::vector<Loan> loans;
    };

    template <class Record>
    void send(Loan& loan, const std::vector<Record>& bodies);

    template <class Record>
    void receive(Loan& loan, std::vector<Record>& bodies);

    const Communicator* communicator_;
    std::vector<int> insides_;
    std::vector<Round> rounds_;
};

template <int D>
template <class Record, class Work>
void Schedule<D>::pass(std::vector<Record>& bodies, Work&& work)
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

template <int D>
template <class Record>
void Schedule<D>::send(Loan& loan, const std::vector<Record>& bodies)
{
    loan.buffer.resize(loan.grains.size() * sizeof(Record));
    for (std::size_t k = 0; k < loan.grains.size(); ++k)
    {
        std::memcpy(loan.buffer.data() + k * sizeof(Record), static_cast<const void*>(&bodies[loan.grains[k]]),
                    sizeof(Record));
    }
    MPI_Isend(loan.buffer.data(), loan.bytes(), MPI_BYTE, loan.rank, loan.tag, communicator_->handle(), &loan.sent);
}

template <int D>
template <class Record>
void Schedule<D>::receive(Loan& loan, std::vector<Record>& bodies)
{
    MPI_Wait(&loan.sent, MPI_STATUS_IGNORE);   // our own message, still in the same buffer
    loan.buffer.resize(loan.grains.size() * sizeof(Record));
    MPI_Recv(loan.buffer.data(), loan.bytes(), MPI_BYTE, loan.rank, loan.tag, communicator_->handle(),
             MPI_STATUS_IGNORE);
    for (std::size_t k = 0; k < loan.grains.size(); ++k)
    {
        std::memcpy(static_cast<void*>(&bodies[loan.grains[k]]), loan.buffer.data() + k * sizeof(Record),
                    sizeof(Record));
    }
}

}  // namespace nscd
