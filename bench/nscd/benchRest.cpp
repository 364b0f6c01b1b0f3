// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A pile at rest must stay at rest: drift of its centre of mass, overlaps, energy.
//
//     benchRest [discs|spheres] [steps] [sweeps] [tolerance/d] [grains] [steps to settle]

#include "nscd/base/Random.hpp"
#include "nscd/dynamics/ContactDynamics.hpp"
#include "nscd/packing/Packing.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{

constexpr double density = 1500, g = 9.81, r = 1.5e-3, d = 2 * r;

/// Grains between 0.9 and 1 of r on a loose lattice in a box a hundred discs or 20 spheres wide.
template <int D>
nscd::ContactDynamics<D> loose(std::size_t count, int sweeps, double tolerance)
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
    settings.tolerance = tolerance * d;
    return {std::move(grains), walls, table, settings};
}

/// Height of the centre of mass [m] and kinetic energy [J].
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
    return {moment / mass, energy};
}

/// Work of the contacts with the mean of the velocities before and after the step [J].
template <int D>
double meanWork(const nscd::ContactDynamics<D>& dynamics, const nscd::Grains<D>& before)
{
    double work = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        const nscd::Grains<D>& now = dynamics.grains();
        work += 0.5 * dynamics.contactImpulse()[i].dot(before.velocity[i] + now.velocity[i]) +
                0.5 * dynamics.contactSpinImpulse()[i].dot(before.spin[i] + now.spin[i]);
    }
    return work;
}

/// Largest values between two lines of the table; energies are over the weight of all grains times the height of
/// their centre of mass.
struct Worst
{
    double rise = 0, overlap = 0, work = -1, meanWork = -1, gain = -1;
    int sweeps = 0, unconverged = 0;
};

template <int D>
void run(int steps, int sweeps, double tolerance, std::size_t count, int settling)
{
    const double dt = D == 2 ? 1e-3 : 5e-4;
    nscd::ContactDynamics<D> dynamics = loose<D>(count, sweeps, tolerance);
    nscd::Vectors<D> force;
    double weight = 0;
    for (const double m : dynamics.grains().mass)
    {
        force.push_back(-g * m * nscd::Vector<D>::Unit(D - 1));
        weight += g * m;
    }
    const nscd::Spins<D> noTorque(force.size(), nscd::Spin<D>::Zero());
    for (int step = 0; step < settling; ++step)
    {
        dynamics.step(force, noTorque, dt);
    }

    std::printf("%zu grains, dt %g s, at most %d sweeps, tolerance %g d, %d steps after %d to settle\n", force.size(),
                dt, sweeps, tolerance, steps, settling);
    std::printf("%6s %6s %5s %9s %9s %9s %9s %9s %9s %9s %9s\n", "step", "sweeps", "capped", "rise/d", "most/step",
                "worst/d", "mean/d", "KE", "work", "meanWork", "gain");
    auto [height, kinetic] = measure(dynamics.grains());
    const double start = height;
    Worst most;
    for (int step = 1; step <= steps; ++step)
    {
        const nscd::Grains<D> before = dynamics.grains();
        const nscd::StepReport report = dynamics.step(force, noTorque, dt);
        const auto [nextHeight, nextKinetic] = measure(dynamics.grains());
        const double energy = weight * height;
        most.rise = std::max(most.rise, std::abs(nextHeight - height) / d);
        most.overlap = std::max(most.overlap, report.worstOverlap / d);
        most.work = std::max(most.work, report.contactWork / energy);
        most.meanWork = std::max(most.meanWork, meanWork(dynamics, before) / energy);
        most.gain = std::max(most.gain, (nextKinetic - kinetic + weight * (nextHeight - height)) / energy);
        most.sweeps += report.sweeps;
        most.unconverged += !report.converged;
        height = nextHeight;
        kinetic = nextKinetic;
        const int line = std::max(1, steps / 10);
        if (step % line == 0)
        {
            std::printf("%6d %6.1f %5d %9.1e %9.1e %9.1e %9.1e %9.1e %9.1e %9.1e %9.1e\n", step,
                        static_cast<double>(most.sweeps) / line, most.unconverged, (height - start) / d, most.rise,
                        most.overlap, report.meanOverlap / d, kinetic / energy, most.work, most.meanWork, most.gain);
            std::fflush(stdout);
            most = {};
        }
    }
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const bool spheres = argc > 1 && std::string(argv[1]) == "spheres";
    const int steps = argc > 2 ? std::atoi(argv[2]) : 10000;
    const int sweeps = argc > 3 ? std::atoi(argv[3]) : 200;
    const double tolerance = argc > 4 ? std::atof(argv[4]) : 3e-7;
    const std::size_t count = argc > 5 ? std::strtoul(argv[5], nullptr, 10) : 10000;
    const int settling = argc > 6 ? std::atoi(argv[6]) : 2000;
    (spheres ? run<3> : run<2>)(steps, sweeps, tolerance, count, settling);
    MPI_Finalize();
    return 0;
}
