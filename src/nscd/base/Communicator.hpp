// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Mpi.hpp"

#include <cstddef>
#include <vector>

namespace nscd
{

/// The ranks that share the work, over a duplicate of the parent communicator.
/// Without MPI_Init it is one rank and no function below calls MPI.
class Communicator
{
public:
    explicit Communicator(MPI_Comm parent);
    ~Communicator();

    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;

    int rank() const { return rank_; }
    int size() const { return size_; }
    MPI_Comm handle() const { return communicator_; }

    /// Largest value over all ranks.
    double max(double value) const;

    /// Element-wise sum over all ranks; exact, for every number of ranks, when one rank only has a non-zero element.
    void sum(std::vector<double>& values) const;
    void sum(std::vector<int>& values) const;

    /// Concatenation of all ranks' lists, in the order of ranks, on every rank.
    template <class T>
    std::vector<T> gather(std::vector<T> mine) const
    {
        if (size_ == 1)
        {
            return mine;
        }
        const std::vector<std::size_t> ends = endsOf(mine.size() * sizeof(T));
        std::vector<T> all(ends.back() / sizeof(T));
        gatherBytes(mine.data(), all.data(), ends);
        return all;
    }

    /// Each rank knows the elements [begin[rank], begin[rank + 1]) of the list; afterwards all know the whole.
    template <class T>
    void share(std::vector<T>& list, const std::vector<std::size_t>& begin) const
    {
        std::vector<std::size_t> ends(size_);
        for (int r = 0; r < size_; ++r)
        {
            ends[r] = begin[r + 1] * sizeof(T);
        }
        gatherBytes(nullptr, list.data(), ends);
    }

    /// Bytes of rank 0 to all ranks.
    void broadcast(std::vector<char>& bytes) const;

private:
    std::vector<std::size_t> endsOf(std::size_t bytes) const;

    /// Null 'mine' means that this rank's part stands in 'all' already.
    void gatherBytes(const void* mine, void* all, const std::vector<std::size_t>& ends) const;

    MPI_Comm communicator_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
};

}  // namespace nscd
