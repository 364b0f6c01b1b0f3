// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run under mpirun: a run on all ranks must equal, bit for bit, the same run that every rank makes on its own.

#include "Scene.hpp"

#include "nscd/base/Communicator.hpp"

#include <cfenv>
#include <cstdio>

namespace
{

int failures = 0;

void expect(bool fact, const char* what)
{
    if (!fact)
    {
        ++failures;
        std::fprintf(stderr, "failed: %s\n", what);
    }
}

template <int D>
void compareRuns(int perSide, int blocks, double restitution = 0, double massRatio = 1)
{
    Scene<D> scene = agitated<D>(perSide, 0.4);
    scene.settings.blocks = blocks;
    scene.table.set(0, 0, {0.4, restitution});
    scene.table.set(0, 1, {0.4, restitution});
    for (std::size_t i = 0; i < scene.grains.size(); i += 4)
    {
        scene.grains.mass[i] *= massRatio;
    }
    auto alone = scene.dynamics(MPI_COMM_SELF);
    auto together = scene.dynamics(MPI_COMM_WORLD);
    alone.recordTouching(true);
    together.recordTouching(true);
    bool same = true;
    for (int i = 0; i < 250; ++i)
    {
        const nscd::StepReport a = fall<D>(alone, up<D>(-g), 5e-3);
        const nscd::StepReport b = fall<D>(together, up<D>(-g), 5e-3);
        same = sameReport(a, b) && sameBits(alone, together) && sameTouching(alone, together) && same;
    }
    expect(same, "250 steps are the same on all ranks as on one");

    const int ranks = nscd::Communicator(MPI_COMM_WORLD).size();
    const std::string file = "nscd_" + std::to_string(ranks) + "ranks_" + std::to_string(D) + ".h5";
    together.save(file, 1);
    alone.load(file);
    bool sameAfterRestart = sameBits(alone, together);
    for (int i = 0; i < 50; ++i)
    {
        fall<D>(alone, up<D>(-g), 5e-3);
        fall<D>(together, up<D>(-g), 5e-3);
        sameAfterRestart = sameAfterRestart && sameBits(alone, together);
    }
    expect(sameAfterRestart, "a state saved by all ranks continues the same on one");

    std::vector<bool> gone(alone.grains().size());
    for (std::size_t i = 0; i < gone.size(); i += 3)
    {
        gone[i] = true;
    }
    alone.remove(gone);
    together.remove(gone);
    bool sameAfterRemoval = sameContacts(alone, together) && !alone.contacts().empty();
    for (int i = 0; i < 20; ++i)
    {
        fall<D>(alone, up<D>(-g), 5e-3);
        fall<D>(together, up<D>(-g), 5e-3);
        sameAfterRemoval = sameContacts(alone, together) && sameBits(alone, together) && sameAfterRemoval;
    }
    expect(sameAfterRemoval, "what stays after a removal has the same contacts, and continues the same");
    MPI_Barrier(MPI_COMM_WORLD);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0)
    {
        std::remove(file.c_str());
    }
}

void checkErrors()
{
    auto dynamics = agitated<2>(4, 0).dynamics(MPI_COMM_WORLD);
    bool refused = false;
    try
    {
        dynamics.save("/nowhere/grains.h5", 0);   // only rank 0 writes
    }
    catch (const std::runtime_error&)
    {
        refused = true;
    }
    expect(refused, "all ranks throw when one cannot write");
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    compareRuns<2>(20, 8);
    compareRuns<2>(3, 2);   // fewer blocks than ranks
    compareRuns<3>(7, 16);
    compareRuns<2>(15, 8, 0.97);
    compareRuns<3>(5, 16, 0.97);
    compareRuns<2>(10, 8, 0, 1e3);   // which is accelerated; with 1e5 sixty sweeps leave overlaps of a radius
    checkErrors();
    MPI_Allreduce(MPI_IN_PLACE, &failures, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    MPI_Finalize();
    return failures == 0 ? 0 : 1;
}
