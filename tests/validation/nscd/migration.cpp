// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run under mpirun: spheres tumble in a drum for ten thousand steps, so that they wander from rank to rank; no grain is
// lost or doubled, and the state is that of one rank alone, bit for bit.

#include "Scene.hpp"

#include "nscd/search/Bisection.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace
{

constexpr double radius = 16, depth = 12, spin = 0.2, dt = 1e-2;   // grains of 1 m; Froude number 0.065

/// A drum about the y axis, a bit less than half full.
nscd::ContactDynamics<3> drum(MPI_Comm communicator)
{
    Scene<3> scene(0.5);
    constexpr int sides = 24;
    const auto corner = [](int k, double y)
    {
        const double angle = 2 * M_PI * k / sides;
        return nscd::Vector<3>(radius * std::cos(angle), y, radius * std::sin(angle));
    };
    for (int k = 0; k < sides; ++k)
    {
        scene.walls.push_back(nscd::Triangle{corner(k, -1), corner(k + 1, -1), corner(k + 1, depth + 1), 1, 0});
        scene.walls.push_back(nscd::Triangle{corner(k, -1), corner(k + 1, depth + 1), corner(k, depth + 1), 1, 0});
    }
    scene.walls.push_back(nscd::Plane{{0, 0, 0}, {0, 1, 0}, 1});
    scene.walls.push_back(nscd::Plane{{0, depth, 0}, {0, -1, 0}, 1});
    nscd::Random random(3);
    for (double z = -12; z < 3; z += 2.1)
    {
        for (double y = 1.05; y < depth - 1; y += 2.1)
        {
            for (double x = -13; x < 13.1; x += 2.1)
            {
                if (std::hypot(x, z) < radius * std::cos(M_PI / sides) - 1.1)
                {
                    const double r = random.uniform(0.8, 1);
                    scene.add({x, y, z}, nscd::Vector<3>::Zero(), r, r * r * r);
                }
            }
        }
    }
    scene.settings.tolerance = 1e-4;
    scene.settings.maxSweeps = 20;
    nscd::ContactDynamics<3> dynamics(scene.grains, scene.walls, scene.table, scene.settings, communicator,
                                      std::vector<nscd::WallBody<3>>(1));
    dynamics.setWallMotion(0, nscd::Vector<3>::Zero(), nscd::Spin<3>(0, spin, 0));
    return dynamics;
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const int steps = argc > 1 ? std::atoi(argv[1]) : 10000;
    auto together = drum(MPI_COMM_WORLD);
    auto alone = drum(MPI_COMM_SELF);
    std::vector<int> half = nscd::bisect<3>(together.grains().position, 2);
    std::size_t changes = 0;
    bool same = true;
    for (int step = 0; step < steps; ++step)
    {
        fall<3>(together, up<3>(-g), dt);
        fall<3>(alone, up<3>(-g), dt);
        same = same && sameBits(alone, together);
        if (step % 100 == 99)
        {
            const auto now = nscd::bisect<3>(together.grains().position, 2);
            for (std::size_t i = 0; i < now.size(); ++i)
            {
                changes += now[i] != half[i];
            }
            half = now;
        }
    }
    std::size_t outside = 0;
    for (const nscd::Vector<3>& x : together.grains().position)
    {
        outside += std::hypot(x.x(), x.z()) > radius || x.y() < 0 || x.y() > depth;
    }
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const auto n = together.grains().size();
    if (rank == 0)
    {
        std::printf("%zu grains, %d steps, %zu changes of the half, %zu outside, %s\n", n, steps, changes, outside,
                    same ? "as one rank" : "NOT as one rank");
    }
    // a grain changes the half some twice a turn
    const bool good = same && outside == 0 && 20000 * changes > n * static_cast<std::size_t>(steps);
    MPI_Finalize();
    return good ? 0 : 1;
}
