// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Spheres that have settled in layers: wall seconds of a step and of its parts, for any number of ranks.
//
//     mpirun -np 2 benchRanks [grains] [steps to settle] [steps] [layers] [sweeps]

#include "Layers.hpp"

#include "nscd/base/Stopwatch.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const auto value = [&](int k, int other) { return argc > k ? std::atoi(argv[k]) : other; };
    const int settling = value(2, 400), steps = value(3, 50);
    Layers<3> pile(value(1, 100000), value(4, 20));
    nscd::ContactTable table;
    table.set(0, 0, {0.3});
    nscd::Settings settings;
    settings.maxSweeps = value(5, 20);
    settings.tolerance = 1e-7;
    nscd::ContactDynamics<3> dynamics(std::move(pile.grains), pile.walls, table, settings);
    const nscd::Spins<3> noTorque(pile.weight.size(), nscd::Spin<3>::Zero());
    const double dt = 5e-4;
    for (int step = 0; step < settling; ++step)
    {
        dynamics.step(pile.weight, noTorque, dt);
    }

    nscd::StepReport last;
    double detection = 0, sweeps = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    const nscd::Stopwatch watch;
    for (int step = 0; step < steps; ++step)
    {
        last = dynamics.step(pile.weight, noTorque, dt);
        detection += last.detectionTime;
        sweeps += last.sweeps;
    }
    const double seconds = watch.seconds();
    double height = 0;
    for (const nscd::Vector<3>& x : dynamics.grains().position)
    {
        height += x.z();
    }
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (rank == 0)
    {
        std::printf("%d ranks, %zu grains, %zu contacts, %.1f sweeps per step: %.1f ms per step, %.1f ms of detection; "
                    "mean height %.17g m\n",
                    ranks, pile.weight.size(), last.contacts, sweeps / steps, 1e3 * seconds / steps,
                    1e3 * detection / steps, height / static_cast<double>(pile.weight.size()));
    }
    MPI_Finalize();
    return 0;
}
