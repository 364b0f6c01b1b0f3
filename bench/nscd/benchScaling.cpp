// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Time per step and memory per grain for 10^3 to 10^6 grains that fall and settle in layers of constant depth, ten
// sweeps a step.
//
//     benchScaling [largest number] > scaling.csv

#include "nscd/Packing.hpp"
#include "nscd/Random.hpp"
#include "nscd/Stopwatch.hpp"

#include <cmath>
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
    const double r = 1e-3;
    const double pitch = 2.05 * r;
    const auto perLayer = static_cast<double>(count) / layers;
    const double side = pitch * std::ceil(D == 2 ? perLayer : std::sqrt(perLayer));
    const double before = residentBytes();

    nscd::Box<D> box;
    box.lower.setZero();
    box.upper.setConstant(side + 0.5 * r);
    box.upper[D - 1] = pitch * layers * 1.2;
    nscd::Walls<D> walls;
    if constexpr (D == 2)
    {
        const nscd::Vector<2> a(0, 0), b(box.upper.x(), 0), c(box.upper), d(0, box.upper.y());
        walls = {{a, b}, {b, c}, {d, a}};
    }
    else
    {
        walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::UnitZ()});
        for (int axis = 0; axis < 2; ++axis)
        {
            walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::Unit(axis)});
            walls.push_back(nscd::Plane{box.upper, -nscd::Vector<3>::Unit(axis)});
        }
    }
    const nscd::Vectors<D> centres = nscd::lattice<D>(box, r, pitch);
    nscd::Grains<D> grains;
    grains.resize(std::min(count, centres.size()));
    nscd::Random random(1);
    nscd::Vectors<D> weight;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        grains.id[i] = static_cast<std::int64_t>(i);
        grains.position[i] = centres[i];
        grains.radius[i] = r * random.uniform(0.9, 1);
        grains.mass[i] = 2500 * std::pow(grains.radius[i], D);
        for (int d = 0; d < D; ++d)
        {
            grains.velocity[i][d] = random.uniform(-0.05, 0.05);
        }
        weight.push_back(-9.81 * grains.mass[i] * nscd::Vector<D>::Unit(D - 1));
    }
    nscd::ContactTable table;
    table.set(0, 0, {0.3});
    nscd::Settings settings;
    settings.maxSweeps = 10;
    settings.tolerance = 1e-15;
    nscd::ContactDynamics<D> dynamics(std::move(grains), walls, table, settings, MPI_COMM_SELF);
    const nscd::Spins<D> noTorque(weight.size(), nscd::Spin<D>::Zero());
    double seconds = 0, solves = 0;
    std::size_t contacts = 0;
    for (int step = 0; step < settling + measured; ++step)
    {
        const nscd::Stopwatch watch;
        const nscd::StepReport report = dynamics.step(weight, noTorque, 5e-4);
        if (step >= settling)
        {
            seconds += watch.seconds();
            solves += static_cast<double>(report.solves);
        }
        contacts = report.contacts;
    }
    const auto n = static_cast<double>(weight.size());
    std::printf("%d,%zu,%zu,%.4g,%.4g,%.4g,%.4g\n", D, weight.size(), contacts, 1e3 * seconds / measured,
                1e6 * seconds / measured / n, solves / seconds / 1e6, (residentBytes() - before) / n);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    const std::size_t largest = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
    std::printf("dimension,grains,contacts,msPerStep,usPerStepAndGrain,millionSolvesPerSecond,bytesPerGrain\n");
    for (std::size_t n = 1000; n <= largest; n *= 10)
    {
        run<2>(n);
        run<3>(n);
    }
    return 0;
}
