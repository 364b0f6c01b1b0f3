// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A pile at rest must stay at rest: drift of its centre of mass, overlaps, energy.
//
//     benchRest [discs|spheres] [steps] [sweeps] [grains] [steps to settle]

#include "nscd/ContactDynamics.hpp"
#include "nscd/Packing.hpp"
#include "nscd/Random.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{

constexpr double density = 1500, g = 9.81, r = 1.5e-3, d = 2 * r;

/// Grains between 0.9 and 1 of r on a loose lattice in a box a hundred discs or 20 spheres wide.
template <int D>
nscd::ContactDynamics<D> loose(std::size_t count, int sweeps)
{
    nscd::Random random(1);
    nscd::Box<D> box;
    box.lower.setZero();
    const double width = (D == 2 ? 100 : 20) * d;
    box.upper.setConstant(width);
    box.upper[D - 1] = 2 * static_cast<double>(count) * std::pow(1.05 * d, D) / std::pow(width, D - 1);
    nscd::Walls<D> walls;
    if constexpr (D == 2)
    {
        const nscd::Vector<2> a = box.lower, c = box.upper, b(c.x(), a.y()), e(a.x(), c.y());
        walls = {{a, b, 0}, {b, c, 0}, {c, e, 0}, {e, a, 0}};
    }
    else
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::Unit(axis), 0});
            walls.push_back(nscd::Plane{box.upper, -nscd::Vector<3>::Unit(axis), 0});
        }
    }
    const nscd::Vectors<D> centres = nscd::lattice<D>(box, r, 1.02 * d);
    nscd::Grains<D> grains;
    grains.resize(std::min(count, centres.size()));
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        grains.id[i] = static_cast<std::int64_t>(i);
        grains.radius[i] = r * random.uniform(0.9, 1);
        grains.position[i] = centres[i];
        grains.position[i][0] += 0.02 * r * random.uniform(-1, 1);
        grains.mass[i] = density * M_PI * grains.radius[i] * grains.radius[i] * (D == 2 ? 1 : 4 * grains.radius[i] / 3);
    }
    nscd::ContactTable table;
    table.set(0, 0, {0.3});
    nscd::Settings settings;
    settings.maxSweeps = sweeps;
    return {std::move(grains), walls, table, settings};
}

/// Height of the centre of mass [m] and kinetic energy of the mean grain [J].
template <int D>
std::pair<double, double> measure(const nscd::Grains<D>& grains)
{
    double mass = 0, moment = 0, energy = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const double surface = grains.radius[i] * grains.radius[i] * grains.spin[i].squaredNorm();
        mass += grains.mass[i];
        moment += grains.mass[i] * grains.position[i][D - 1];
        energy += 0.5 * grains.mass[i] * (grains.velocity[i].squaredNorm() + nscd::inertiaFactor<D> * surface);
    }
    return {moment / mass, energy / static_cast<double>(grains.size())};
}

template <int D>
void run(int steps, int sweeps, std::size_t count, int settling)
{
    const double dt = D == 2 ? 1e-3 : 5e-4;
    nscd::ContactDynamics<D> dynamics = loose<D>(count, sweeps);
    nscd::Vectors<D> weight;
    double meanMass = 0;
    for (const double m : dynamics.grains().mass)
    {
        weight.push_back(-g * m * nscd::Vector<D>::Unit(D - 1));
        meanMass += m / static_cast<double>(dynamics.grains().size());
    }
    const nscd::Spins<D> noTorque(weight.size(), nscd::Spin<D>::Zero());
    for (int step = 0; step < settling; ++step)
    {
        dynamics.step(weight, noTorque, dt);
    }

    const double unit = meanMass * g * d;   // lifts a grain by its diameter
    std::printf("%zu grains, dt %g s, at most %d sweeps, %d steps after %d to settle\n", weight.size(), dt, sweeps,
                steps, settling);
    std::printf("%6s %7s %11s %11s %11s %11s %11s %11s %11s\n", "step", "sweeps", "rise/d", "most/step", "worst/d",
                "mean/d", "vmax/(g dt)", "KE/(mgd)", "gain/(mgd)");
    auto [height, energy] = measure(dynamics.grains());
    const double start = height;
    double fastest = 0, gain = 0, worst = 0;
    int sweepsDone = 0;
    for (int step = 1; step <= steps; ++step)
    {
        const nscd::StepReport report = dynamics.step(weight, noTorque, dt);
        const auto [nextHeight, nextEnergy] = measure(dynamics.grains());
        fastest = std::max(fastest, std::abs(nextHeight - height) / d);
        gain = std::max(gain, (nextEnergy - energy) / unit + (nextHeight - height) / d);
        worst = std::max(worst, report.worstOverlap / d);
        height = nextHeight;
        energy = nextEnergy;
        sweepsDone += report.sweeps;
        if (step % std::max(1, steps / 10) == 0)
        {
            std::printf("%6d %7.1f %11.2e %11.2e %11.2e %11.2e %11.2e %11.2e %11.2e\n", step,
                        sweepsDone / std::max(1.0, steps / 10.0), (height - start) / d, fastest, worst,
                        report.meanOverlap / d, report.maxVelocity / (g * dt), energy / unit, gain);
            std::fflush(stdout);
            fastest = gain = worst = 0;
            sweepsDone = 0;
        }
    }
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const bool spheres = argc > 1 && std::string(argv[1]) == "spheres";
    const int steps = argc > 2 ? std::atoi(argv[2]) : 10000;
    const int sweeps = argc > 3 ? std::atoi(argv[3]) : 30;
    const std::size_t count = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 10000;
    const int settling = argc > 5 ? std::atoi(argv[5]) : 2000;
    (spheres ? run<3> : run<2>)(steps, sweeps, count, settling);
    MPI_Finalize();
    return 0;
}
