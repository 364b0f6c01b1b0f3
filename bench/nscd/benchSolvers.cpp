// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The three solvers on the contact problem of a settled pile: from nothing, and after one of its grains was hit.
//
//     benchSolvers [spheres|rods] [grains] [maxSweeps] [FILE.hdf5]      writes the problem to the file, if there is one

#include "nscd/base/Random.hpp"
#include "nscd/dynamics/RigidMotion.hpp"
#include "nscd/packing/Packing.hpp"
#include "nscd/problem/Delassus.hpp"
#include "nscd/problem/Fclib.hpp"
#include "nscd/problem/SparseSolve.hpp"

#include <cstdio>
#include <cstdlib>

namespace
{

constexpr double dt = 5e-4, radius = 1.5e-3, density = 2500, friction = 0.3;
const nscd::Vector<3> gravity(0, 0, -9.81);

/// Grains that have come to rest in a column twelve diameters wide.
nscd::ContactDynamics<3> pile(bool rods, std::size_t count)
{
    nscd::Random random(1);
    nscd::Box<3> box;
    box.lower.setZero();
    box.upper << 24.8 * radius, 24.8 * radius, 1e3 * radius;
    const nscd::Vectors<3> centres = nscd::lattice<3>(box, radius, 2.05 * radius);
    nscd::Grains<3> grains;
    grains.resize(count);
    if (rods)
    {
        grains.clusters = {nscd::makeRod<3>(3, 2)};
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        const double r = radius * random.uniform(0.9, 1);
        const double volume = rods ? grains.clusters[0].volume : 4 * M_PI / 3;
        grains.id[i] = static_cast<std::int64_t>(i);
        grains.position[i] = centres[i];
        grains.velocity[i] = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0};
        grains.shape[i] = rods ? 0 : -1;
        grains.radius[i] = r;
        grains.mass[i] = density * volume * r * r * r;
        if (rods)
        {
            const nscd::Vector<3> axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            grains.orientation[i] = nscd::Orientation<3>::FromTwoVectors(nscd::Vector<3>::UnitX(), axis);
        }
    }
    nscd::Walls<3> walls;
    for (int axis = 0; axis < 3; ++axis)
    {
        walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::Unit(axis)});
        walls.push_back(nscd::Plane{box.upper, -nscd::Vector<3>::Unit(axis)});
    }
    nscd::ContactTable table;
    table.set(0, 0, {friction});
    nscd::Settings settings;
    settings.maxSweeps = 30;
    nscd::ContactDynamics<3> dynamics(std::move(grains), walls, table, settings, MPI_COMM_SELF);
    nscd::Vectors<3> weight;
    for (const double mass : dynamics.grains().mass)
    {
        weight.push_back(mass * gravity);
    }
    const nscd::Spins<3> noTorque(count, nscd::Spin<3>::Zero());
    for (int step = 0; step < 400; ++step)
    {
        dynamics.step(weight, noTorque, dt);
    }
    return dynamics;
}

/// The grains with the velocities that gravity alone would give them, and after them the walls.
std::vector<nscd::RigidBody<3>> bodiesOf(const nscd::Grains<3>& grains)
{
    std::vector<nscd::RigidBody<3>> bodies;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const nscd::Turning<3> turning = nscd::turningOf(grains, i);
        bodies.push_back({grains.position[i], grains.velocity[i] + dt * gravity, grains.spin[i], 1 / grains.mass[i],
                          turning.inverse / (turning.length * turning.length)});
    }
    const nscd::Vector<3> zero = nscd::Vector<3>::Zero();
    bodies.push_back({zero, zero, zero, 0, nscd::SpinMatrix<3>::Zero()});
    return bodies;
}

std::vector<nscd::ContactPoint<3>> contactsOf(const nscd::ContactDynamics<3>& dynamics)
{
    const int walls = static_cast<int>(dynamics.grains().size());
    std::vector<nscd::ContactPoint<3>> contacts;
    for (const nscd::ContactForce<3>& c : dynamics.contacts())
    {
        contacts.push_back(
            {c.first, c.second < 0 ? walls : c.second, c.point, c.normal, std::max(0.0, c.gap) / dt, friction});
    }
    return contacts;
}

void compare(const char* what, const nscd::SparseProblem<3>& problem, int maxSweeps, const nscd::Vectors<3>& start)
{
    const double worst = residual(problem, start).worst;
    std::printf("\n%s: %d contacts, %.1f blocks of W each, residual %.2e m/s\n", what, problem.contacts(),
                double(problem.blocks()) / problem.contacts(), worst);
    std::printf("%10s %10s %10s %10s %10s %10s %10s\n", "to", "solver", "sweeps", "CPU ms", "M/s", "worst", "rms");
    for (const double factor : {1e-2, 1e-3, 1e-4})
    {
        for (const char* name : {"sweeps", "queue", "nesterov"})
        {
            const nscd::SolveLimits limits{factor * worst, maxSweeps};
            const auto s = nscd::solve<3>(problem, nscd::solverOfName(name), limits, start);
            std::printf("%10.0e %10s %10.2f %10.2f %10.1f %10.1e %10.1e%s\n", factor, name, s.sweeps,
                        1e3 * s.cpuSeconds, 1e-6 * s.sweeps * problem.contacts() / std::max(s.cpuSeconds, 1e-6),
                        s.residual.worst / worst, s.residual.relative, s.converged ? "" : " not converged");
            std::fflush(stdout);
        }
    }
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const bool rods = argc > 1 && std::string(argv[1]) == "rods";
    const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 2500;
    const int maxSweeps = argc > 3 ? std::atoi(argv[3]) : 20000;
    const nscd::ContactDynamics<3> dynamics = pile(rods, count);
    std::vector<nscd::RigidBody<3>> bodies = bodiesOf(dynamics.grains());
    const auto contacts = contactsOf(dynamics);
    const auto problem = nscd::delassus(bodies, contacts);
    if (argc > 4)
    {
        nscd::writeFclib<3>(argv[4], {problem, {}, {}});
    }
    const nscd::Vectors<3> none(contacts.size(), nscd::Vector<3>::Zero());
    compare("From nothing", problem, maxSweeps, none);

    const nscd::SolveLimits deep{1e-7 * residual(problem, none).worst, 100 * maxSweeps};
    const auto rest = nscd::solve<3>(problem, nscd::Solver::nesterov, deep);
    bodies[count / 2].velocity += 10 * dt * gravity;
    compare("One grain hit, from the solution at rest", nscd::delassus(bodies, contacts), maxSweeps, rest.r);
    MPI_Finalize();
    return 0;
}
