// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Time per step and memory per grain for 10^3 to 10^6 grains that fall and settle in layers of constant depth, ten
// sweeps a step.
//
//     benchScaling [largest number] > scaling.csv

#include "Layers.hpp"

#include "nscd/base/Stopwatch.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace
{

constexpr int layers = 20;
constexpr int settling = 40;
constexpr int measured = 20;

double residentBytes()
{
    std::ifstream status("/proc/self/statm");
    double size, resident;
    status >> size >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

template <int D>
void run(std::size_t count)
{
    const double before = residentBytes();
    Layers<D> pile(count, layers);
    nscd::ContactTable table;
    table.set(0, 0, {0.3});
    nscd::Settings settings;
    settings.maxSweeps = 10;
    settings.tolerance = 1e-15;
    nscd::ContactDynamics<D> dynamics(std::move(pile.grains), pile.walls, table, settings, MPI_COMM_SELF);
    const nscd::Spins<D> noTorque(pile.weight.size(), nscd::Spin<D>::Zero());
    double seconds = 0, detection = 0, solves = 0;
    std::size_t contacts = 0;
    for (int step = 0; step < settling + measured; ++step)
    {
        const nscd::Stopwatch watch;
        const nscd::StepReport report = dynamics.step(pile.weight, noTorque, 5e-4);
        if (step >= settling)
        {
            seconds += watch.seconds();
            detection += report.detectionTime;
            solves += static_cast<double>(report.solves);
        }
        contacts = report.contacts;
    }
    const auto n = static_cast<double>(pile.weight.size());
    std::printf("%d,%zu,%zu,%.4g,%.4g,%.4g,%.4g,%.4g\n", D, pile.weight.size(), contacts, 1e3 * seconds / measured,
                1e6 * seconds / measured / n, 1e6 * detection / measured / n,
                solves / seconds / 1e6, (residentBytes() - before) / n);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    const std::size_t largest = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
    std::printf("dimension,grains,contacts,msPerStep,usPerStepAndGrain,detectionUs,millionSolvesPerSecond,"
                "bytesPerGrain\n");
    for (std::size_t n = 1000; n <= largest; n *= 10)
    {
        run<2>(n);
        run<3>(n);
    }
    return 0;
}
