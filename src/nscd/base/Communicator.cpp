// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/base/Communicator.hpp"

#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace nscd
{

namespace
{

bool mpiIsUp()
{
    int initialized = 0;
    int finalized = 0;
    MPI_Initialized(&initialized);
    MPI_Finalized(&finalized);
    return initialized && !finalized;
}

int toCount(std::size_t bytes)
{
    if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
        throw std::runtime_error("a message of " + std::to_string(bytes) + " bytes is too long for MPI");
    }
    return static_cast<int>(bytes);
}

}  // namespace

Communicator::Communicator(MPI_Comm parent)
{
    if (mpiIsUp())
    {
        MPI_Comm_dup(parent, &communicator_);
        MPI_Comm_rank(communicator_, &rank_);
        MPI_Comm_size(communicator_, &size_);
    }
}

Communicator::~Communicator()
{
    if (communicator_ != MPI_COMM_NULL && mpiIsUp())
    {
        MPI_Comm_free(&communicator_);
    }
}

double Communicator::max(double value) const
{
    if (size_ > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    }
    return value;
}

void Communicator::sum(std::vector<double>& values) const
{
    if (size_ > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, values.data(), toCount(values.size()), MPI_DOUBLE, MPI_SUM, communicator_);
    }
}

void Communicator::sum(std::vector<int>& values) const
{
    if (size_ > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, values.data(), toCount(values.size()), MPI_INT, MPI_SUM, communicator_);
    }
}

void Communicator::broadcast(std::vector<char>& bytes) const
{
    if (size_ > 1)
    {
        int n = toCount(bytes.size());
        MPI_Bcast(&n, 1, MPI_INT, 0, communicator_);
        bytes.resize(n);
        MPI_Bcast(bytes.data(), n, MPI_CHAR, 0, communicator_);
    }
}

std::vector<std::size_t> Communicator::endsOf(std::size_t bytes) const
{
    std::vector<unsigned long long> counts(size_, bytes);
    if (size_ > 1)
    {
        const unsigned long long mine = bytes;
        MPI_Allgather(&mine, 1, MPI_UNSIGNED_LONG_LONG, counts.data(), 1, MPI_UNSIGNED_LONG_LONG, communicator_);
    }
    std::vector<std::size_t> ends(size_);
    std::size_t sum = 0;
    for (int r = 0; r < size_; ++r)
    {
        sum += counts[r];
        ends[r] = sum;
    }
    return ends;
}

void Communicator::gatherBytes(const void* mine, void* all, const std::vector<std::size_t>& ends) const
{
    if (size_ == 1)
    {
        if (mine && ends[0] > 0)
        {
            std::memcpy(all, mine, ends[0]);
        }
        return;
    }
    std::vector<int> counts(size_), offsets(size_);
    for (int r = 0; r < size_; ++r)
    {
        const std::size_t begin = r ? ends[r - 1] : 0;
        offsets[r] = toCount(begin);
        counts[r] = toCount(ends[r] - begin);
    }
    MPI_Allgatherv(mine ? mine : MPI_IN_PLACE, mine ? counts[rank_] : 0, MPI_BYTE, all, counts.data(), offsets.data(),
                   MPI_BYTE, communicator_);
}

}  // namespace nscd
