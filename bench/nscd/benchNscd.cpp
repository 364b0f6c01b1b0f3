// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Discs or spheres that settle in a box: contact solves per second, time per step, overlaps.
//
//     benchNscd [random|hexagonal|spheres] [steps] [sweeps] [grains]
//     mpirun -np 2 benchNscd ...

#include "nscd/base/Random.hpp"
#include "nscd/packing/Packing.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{

constexpr double density = 1500;

/// Ten thousand discs of 1.5 mm in a box 0.4 m wide and 0.6 m high, or as many spheres in a square column.
template <int D>
void run(const std::string& packing, int steps, int sweeps, std::size_t count, bool prints)
{
    const double r = 1.5e-3;
    const double dt = D == 2 ? 1e-3 : 5e-4;
    nscd::Box<D> box;
    box.lower.setZero();
    nscd::Walls<D> walls;
    nscd::Vectors<D> centres;
    nscd::Random random(1);
    std::vector<double> radii(count, r);
    if constexpr (D == 2)
    {
        box.upper << 0.4, 0.6;
        const nscd::Vector<2> a = box.lower, c = box.upper, b(c.x(), a.y()), d(a.x(), c.y());
        walls = {{a, b, 0}, {b, c, 0}, {c, d, 0}, {d, a, 0}};
        if (packing == "random")
        {
            for (double& radius : radii)
            {
                radius *= random.uniform(0.9, 1);
            }
            centres = nscd::randomFill<2>(box, radii, 1);
        }
        else
        {
            centres = nscd::hexagonal<2>(box, r);
        }
    }
    else
    {
        box.upper << 0.06, 0.06, 0.6;
        for (int axis = 0; axis < 3; ++axis)
        {
            walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::Unit(axis), 0});
            walls.push_back(nscd::Plane{box.upper, -nscd::Vector<3>::Unit(axis), 0});
        }
        for (double& radius : radii)
        {
            radius *= random.uniform(0.9, 1);
        }
        centres = nscd::lattice<3>(box, r, 2.05 * r);
    }

    nscd::Grains<D> grains;
    grains.resize(std::min(count, centres.size()));
    nscd::Vectors<D> weight;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        grains.id[i] = static_cast<std::int64_t>(i);
        grains.position[i] = centres[i];
        grains.radius[i] = radii[i];
        grains.mass[i] = density * M_PI * radii[i] * radii[i] * (D == 2 ? 1 : 4 * radii[i] / 3);
        weight.push_back(-9.81 * grains.mass[i] * nscd::Vector<D>::Unit(D - 1));
    }
    nscd::ContactTable table;
    table.set(0, 0, {0.3});
    nscd::Settings settings;
    settings.maxSweeps = sweeps;
    nscd::ContactDynamics<D> dynamics(std::move(grains), walls, table, settings);

    const nscd::Spins<D> noTorque(weight.size(), nscd::Spin<D>::Zero());
    const int shown = std::max(1, steps / 10);
    double detection = 0, solution = 0, solves = 0;
    if (prints)
    {
        std::printf("%zu grains, dt %g s, at most %d sweeps\n", weight.size(), dt, sweeps);
        std::printf("%6s %9s %8s %8s %9s %9s %11s %11s %9s\n", "step", "contacts", "sweeps", "M/s", "ms/step",
                    "detect %", "mean/d", "worst/d", "vmax m/s");
    }
    int sweepsDone = 0;
    for (int step = 1; step <= steps; ++step)
    {
        const nscd::StepReport report = dynamics.step(weight, noTorque, dt);
        detection += report.detectionTime;
        solution += report.solutionTime;
        solves += static_cast<double>(report.solves);
        sweepsDone += report.sweeps;
        if (step % shown == 0)
        {
            if (prints)
            {
                std::printf("%6d %9zu %8.1f %8.1f %9.2f %9.0f %11.2e %11.2e %9.3f\n", step, report.contacts,
                            double(sweepsDone) / shown, solves / solution / 1e6, 1e3 * (detection + solution) / shown,
                            100 * detection / (detection + solution), report.meanOverlap / (2 * r),
                            report.worstOverlap / (2 * r), report.maxVelocity);
            }
            detection = solution = solves = 0;
            sweepsDone = 0;
        }
    }
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const std::string packing = argc > 1 ? argv[1] : "hexagonal";
    const int steps = argc > 2 ? std::atoi(argv[2]) : 500;
    const int sweeps = argc > 3 ? std::atoi(argv[3]) : 30;
    const std::size_t count = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 10000;
    if (packing == "spheres")
    {
        run<3>(packing, steps, sweeps, count, rank == 0);
    }
    else
    {
        run<2>(packing, steps, sweeps, count, rank == 0);
    }
    MPI_Finalize();
    return 0;
}
