// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A packed heap of 10 000 discs under its weight.
//
//     benchPacked make packed.csv                                      lets discs fall and settle; x, y, r
//     benchPacked run packed.csv steps dt maxSweeps tolerance solver   CPU seconds per step, worst overlap over r

#include "nscd/base/Random.hpp"
#include "nscd/packing/Packing.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

namespace
{

constexpr double width = 0.4;
constexpr double height = 0.8;
constexpr double density = 1500;
constexpr std::size_t count = 10000;

nscd::Grains<2> fallen()
{
    const nscd::Vectors<2> centres = nscd::lattice<2>({{0, 0}, {width, height}}, 1.5e-3, 3.4e-3);
    nscd::Grains<2> grains;
    grains.resize(count);
    nscd::Random random(1);
    for (std::size_t i = 0; i < count; ++i)
    {
        grains.position[i] = centres[i] + nscd::Vector<2>(random.uniform(-1e-4, 1e-4), 0);
        grains.radius[i] = 1.5e-3 * random.uniform(0.9, 1);
    }
    return grains;
}

nscd::Grains<2> read(const char* name)
{
    std::ifstream in(name);
    nscd::Grains<2> grains;
    grains.resize(count);
    char comma;
    for (std::size_t i = 0; i < count; ++i)
    {
        in >> grains.position[i].x() >> comma >> grains.position[i].y() >> comma >> grains.radius[i];
    }
    return grains;
}

nscd::ContactDynamics<2> heap(nscd::Grains<2> grains, int sweeps, double tolerance, nscd::Solver solver)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        grains.id[i] = static_cast<std::int64_t>(i);
        grains.mass[i] = density * M_PI * grains.radius[i] * grains.radius[i];
    }
    const nscd::Vector<2> a(0, 0), b(width, 0), c(width, height), d(0, height);
    nscd::ContactTable table;
    table.set(0, 0, {0.3});
    nscd::Settings settings;
    settings.maxSweeps = sweeps;
    settings.tolerance = tolerance;
    settings.solver = solver;
    return {std::move(grains), {{a, b}, {b, c}, {d, a}}, table, settings};
}

nscd::StepReport fall(nscd::ContactDynamics<2>& dynamics, double dt)
{
    nscd::Vectors<2> weight;
    for (const double m : dynamics.grains().mass)
    {
        weight.push_back({0, -9.81 * m});
    }
    return dynamics.step(weight, nscd::Spins<2>(weight.size(), nscd::Spin<2>::Zero()), dt);
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string action = argc > 1 ? argv[1] : "";
    if (action == "make" && argc == 3)
    {
        nscd::ContactDynamics<2> dynamics = heap(fallen(), 50, 1e-7, nscd::Solver::sweeps);
        for (int step = 0; step < 2000; ++step)
        {
            fall(dynamics, 5e-4);
        }
        std::FILE* out = std::fopen(argv[2], "w");
        for (std::size_t i = 0; i < count; ++i)
        {
            const auto& x = dynamics.grains().position[i];
            std::fprintf(out, "%.12g,%.12g,%.12g\n", x.x(), x.y(), dynamics.grains().radius[i]);
        }
        std::fclose(out);
        return 0;
    }
    if (action != "run" || argc != 8)
    {
        std::fprintf(stderr, "usage: benchPacked make FILE | run FILE steps dt maxSweeps tolerance sweeps|nesterov\n");
        return 2;
    }
    const nscd::Solver solver = std::string(argv[7]) == "nesterov" ? nscd::Solver::nesterov : nscd::Solver::sweeps;
    nscd::ContactDynamics<2> dynamics = heap(read(argv[2]), std::atoi(argv[5]), std::atof(argv[6]), solver);
    const int steps = std::atoi(argv[3]);
    const std::clock_t start = std::clock();
    double worst = 0;
    for (int step = 0; step < steps; ++step)
    {
        worst = std::max(worst, fall(dynamics, std::atof(argv[4])).worstOverlap);
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("| grainFoam, %s, at most %s passes, %s m | %.4f | %.2e |\n", argv[7], argv[5], argv[6],
                seconds / steps, worst / 1.5e-3);
    return 0;
}
