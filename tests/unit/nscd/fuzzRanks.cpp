// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run under mpirun: random scenes on all ranks must equal, bit for bit, those that every rank makes on its own.
//
//     mpirun -np 2 fuzzRanks [seed] [scenes]

#include "RandomScene.hpp"

#include <cfenv>
#include <cstdio>
#include <cstdlib>

namespace
{

struct Outcome
{
    std::string message;   ///< of the step's exception, or nothing
    nscd::StepReport report;
};

/// A step that ends in an exception reports nothing: a new report, as GCC 12 lets the step write into one that is
/// assigned.
template <int D>
Outcome step(nscd::ContactDynamics<D>& dynamics, const RandomScene<D>& random)
{
    try
    {
        return {"", dynamics.step(random.force, random.torque, random.dt)};
    }
    catch (const std::runtime_error& error)
    {
        return {error.what(), {}};
    }
}

/// The step in which ranks and the single rank differ; 0 for never.
template <int D>
int differsInStep(std::uint64_t seed)
{
    RandomScene<D> random(seed);
    auto alone = random.dynamics(MPI_COMM_SELF);
    auto together = random.dynamics(MPI_COMM_WORLD);
    for (int i = 1; i <= 12; ++i)
    {
        random.act({&alone, &together});
        const Outcome a = step(alone, random), b = step(together, random);
        if (a.message != b.message || !sameReport(a.report, b.report) || !sameContacts(alone, together) ||
            !sameBits(alone, together))
        {
            return i;
        }
        if (!a.message.empty() || a.report.subSteps > 200)
        {
            break;
        }
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
    const int scenes = argc > 2 ? std::atoi(argv[2]) : 300;
    int failures = 0;
    for (int k = 0; k < scenes; ++k)
    {
        const std::uint64_t s = seed + static_cast<std::uint64_t>(k);
        int differs = 0;
        try
        {
            differs = s % 2 ? differsInStep<2>(s) : differsInStep<3>(s);
        }
        catch (const std::invalid_argument&)   // a sliver, refused before any message is sent
        {
        }
        MPI_Allreduce(MPI_IN_PLACE, &differs, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
        if (differs > 0)
        {
            ++failures;
            std::fprintf(stderr, "seed %llu: differs in step %d\n", static_cast<unsigned long long>(s), differs);
        }
    }
    MPI_Finalize();
    return failures == 0 ? 0 : 1;
}
