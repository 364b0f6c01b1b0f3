// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Spheres of a CSV file (x, y, z, r) that fall into an open box with a square floor and come to rest.
//
//     benchSettle init.csv side endTime dt maxSweeps tolerance final.csv [sweeps|queue|nesterov]

#include "nscd/dynamics/ContactDynamics.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace
{

constexpr double density = 2500;
constexpr double friction = 0.3;

nscd::Grains<3> read(const std::string& name)
{
    nscd::Grains<3> grains;
    std::ifstream in(name);
    for (std::string line; std::getline(in, line);)
    {
        std::istringstream words(line);
        double x, y, z, r;
        char comma;
        words >> x >> comma >> y >> comma >> z >> comma >> r;
        const std::size_t i = grains.size();
        grains.resize(i + 1);
        grains.id[i] = static_cast<std::int64_t>(i);
        grains.position[i] = {x, y, z};
        grains.radius[i] = r;
        grains.mass[i] = density * 4 / 3 * M_PI * r * r * r;
    }
    return grains;
}

void write(const std::string& name, const nscd::Grains<3>& grains)
{
    std::FILE* out = std::fopen(name.c_str(), "w");
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const auto& x = grains.position[i];
        const auto& v = grains.velocity[i];
        std::fprintf(out, "%.10g,%.10g,%.10g,%.10g,%.10g,%.10g,%.10g\n", x[0], x[1], x[2], grains.radius[i], v[0],
                     v[1], v[2]);
    }
    std::fclose(out);
}

double cpuSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 8 && argc != 9)
    {
        std::fprintf(stderr, "usage: benchSettle init.csv side endTime dt maxSweeps tolerance final.csv [solver]\n");
        return 2;
    }
    MPI_Init(&argc, &argv);
    const double side = std::atof(argv[2]);
    const double dt = std::atof(argv[4]);
    const int steps = static_cast<int>(std::lround(std::atof(argv[3]) / dt));

    nscd::Walls<3> walls{nscd::Plane{{0, 0, 0}, {0, 0, 1}}};
    for (int axis = 0; axis < 2; ++axis)
    {
        walls.push_back(nscd::Plane{nscd::Vector<3>::Zero(), nscd::Vector<3>::Unit(axis)});
        walls.push_back(nscd::Plane{side * nscd::Vector<3>::Unit(axis), -nscd::Vector<3>::Unit(axis)});
    }
    nscd::ContactTable table;
    table.set(0, 0, {friction});
    nscd::Settings settings;
    settings.maxSweeps = std::atoi(argv[5]);
    settings.tolerance = std::atof(argv[6]);
    const std::string solver = argc > 8 ? argv[8] : "sweeps";
    settings.solver = solver == "queue" ? nscd::Solver::queue
                                        : solver == "nesterov" ? nscd::Solver::nesterov : nscd::Solver::sweeps;
    nscd::ContactDynamics<3> dynamics(read(argv[1]), walls, table, settings);

    nscd::Vectors<3> weight;
    for (const double m : dynamics.grains().mass)
    {
        weight.push_back({0, 0, -9.81 * m});
    }
    const nscd::Spins<3> noTorque(weight.size(), nscd::Spin<3>::Zero());

    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const double start = cpuSeconds();
    double sweeps = 0, solves = 0, detection = 0, solution = 0, worst = 0;
    for (int step = 1; step <= steps; ++step)
    {
        const nscd::StepReport report = dynamics.step(weight, noTorque, dt);
        sweeps += report.sweeps;
        solves += static_cast<double>(report.solves);
        detection += report.detectionTime;
        solution += report.solutionTime;
        worst = std::max(worst, report.worstOverlap);
        if (rank == 0 && step % std::max(1, steps / 10) == 0)
        {
            std::printf("t %.3f s  contacts %zu  sweeps %d  overlap mean %.2e worst %.2e m  vmax %.2e m/s\n", step * dt,
                        report.contacts, report.sweeps, report.meanOverlap, report.worstOverlap, report.maxVelocity);
        }
    }
    if (rank == 0)
    {
        std::printf("cpu %.1f s  detection %.1f s  solution %.1f s  sweeps/step %.1f  %.1f M solves/s  "
                    "worst overlap ever %.2e m\n",
                    cpuSeconds() - start, detection, solution, sweeps / steps, solves / solution / 1e6, worst);
        write(argv[7], dynamics.grains());
    }
    MPI_Finalize();
    return 0;
}
