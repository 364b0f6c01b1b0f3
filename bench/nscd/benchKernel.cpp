// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Contact solves per second in a settled pile of spheres: those of a step of 200 sweeps, and those of a plain scalar
// loop over the same contacts in the order of their numbers.
//
//     benchKernel [grains] [steps to settle]

#include "Layers.hpp"

#include "nscd/base/Stopwatch.hpp"

#include <cstdio>
#include <cstdlib>

namespace
{

constexpr double dt = 5e-4, friction = 0.3;
constexpr int sweeps = 200;

struct PlainBody
{
    double v[3] = {0, 0, 0}, w[3] = {0, 0, 0}, radius = 0, inverseMass = 0, inverseInertia = 0;
};

struct PlainContact
{
    int i, j;
    double n[3], gap, wn, wt, normal = 0, slip[3] = {0, 0, 0};
};

/// One Gauss-Seidel solve: relative velocity at the contact, impulses, projections, bodies.
void solve(PlainContact& c, PlainBody& a, PlainBody& b)
{
    const double* n = c.n;
    double s[3], u[3];
    for (int k = 0; k < 3; ++k)
    {
        s[k] = a.radius * a.w[k] + b.radius * b.w[k];
        u[k] = b.v[k] - a.v[k];
    }
    u[0] -= s[1] * n[2] - s[2] * n[1];
    u[1] -= s[2] * n[0] - s[0] * n[2];
    u[2] -= s[0] * n[1] - s[1] * n[0];
    const double un = u[0] * n[0] + u[1] * n[1] + u[2] * n[2];
    double normal = c.normal - (un + c.gap / dt) / c.wn;
    normal = normal > 0 ? normal : 0;
    double t[3], square = 0;
    for (int k = 0; k < 3; ++k)
    {
        t[k] = c.slip[k] - (u[k] - un * n[k]) / c.wt;
        square += t[k] * t[k];
    }
    const double bound = friction * normal;
    const double scale = square > bound * bound ? bound / std::sqrt(square) : 1;
    double p[3], d[3];
    for (int k = 0; k < 3; ++k)
    {
        d[k] = scale * t[k] - c.slip[k];
        c.slip[k] = scale * t[k];
        p[k] = (normal - c.normal) * n[k] + d[k];
        a.v[k] -= a.inverseMass * p[k];
        b.v[k] += b.inverseMass * p[k];
    }
    c.normal = normal;
    const double turn[3] = {n[1] * d[2] - n[2] * d[1], n[2] * d[0] - n[0] * d[2], n[0] * d[1] - n[1] * d[0]};
    for (int k = 0; k < 3; ++k)
    {
        a.w[k] -= a.radius * a.inverseInertia * turn[k];
        b.w[k] -= b.radius * b.inverseInertia * turn[k];
    }
}

/// Million solves per second, and the largest speed that they leave [m/s].
std::pair<double, double> plainLoop(const nscd::Grains<3>& grains, const std::vector<nscd::ContactForce<3>>& forces)
{
    std::vector<PlainBody> bodies(grains.size() + 1);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        bodies[i].v[2] = -9.81 * dt;
        bodies[i].radius = grains.radius[i];
        bodies[i].inverseMass = 1 / grains.mass[i];
        bodies[i].inverseInertia = 1 / (nscd::inertiaFactor<3> * grains.mass[i] * grains.radius[i] * grains.radius[i]);
    }
    std::vector<PlainContact> contacts;
    for (const nscd::ContactForce<3>& f : forces)
    {
        PlainContact& c = contacts.emplace_back();
        c.i = f.first;
        c.j = f.second < 0 ? static_cast<int>(grains.size()) : f.second;
        c.gap = std::max(0.0, f.gap);
        const PlainBody &a = bodies[c.i], &b = bodies[c.j];
        c.wn = a.inverseMass + b.inverseMass;
        c.wt = c.wn + a.radius * a.radius * a.inverseInertia + b.radius * b.radius * b.inverseInertia;
        for (int k = 0; k < 3; ++k)
        {
            c.n[k] = f.normal[k];
        }
    }
    const nscd::Stopwatch watch;
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
        for (PlainContact& c : contacts)
        {
            solve(c, bodies[c.i], bodies[c.j]);
        }
    }
    const double seconds = watch.seconds();
    double fastest = 0;
    for (const PlainBody& b : bodies)
    {
        fastest = std::max(fastest, std::hypot(b.v[0], b.v[1], b.v[2]));
    }
    return {1e-6 * sweeps * static_cast<double>(contacts.size()) / seconds, fastest};
}

}  // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    const auto value = [&](int k, int other) { return argc > k ? std::atoi(argv[k]) : other; };
    Layers<3> pile(value(1, 10000), 20);
    nscd::ContactTable table;
    table.set(0, 0, {friction});
    nscd::Settings settings;
    settings.maxSweeps = sweeps;
    settings.tolerance = 1e-8;
    nscd::ContactDynamics<3> dynamics(std::move(pile.grains), pile.walls, table, settings);
    const nscd::Spins<3> noTorque(pile.weight.size(), nscd::Spin<3>::Zero());
    for (int step = 0; step < value(2, 300); ++step)
    {
        dynamics.step(pile.weight, noTorque, dt);
    }
    // a step under another load, so that all sweeps are used
    for (nscd::Vector<3>& w : pile.weight)
    {
        w.x() = 0.5 * w.z();
    }
    const nscd::StepReport report = dynamics.step(pile.weight, noTorque, dt);
    const auto [plain, fastest] = plainLoop(dynamics.grains(), dynamics.contacts());
    std::printf("%zu spheres, %zu contacts, %d sweeps: %.1f M solves per second with everything that belongs to a "
                "step's solution; plain loop over %zu contacts: %.1f M solves per second (fastest grain %.1e m/s)\n",
                pile.weight.size(), report.contacts, report.sweeps,
                1e-6 * static_cast<double>(report.solves) / report.solutionTime, dynamics.contacts().size(), plain,
                fastest);
    MPI_Finalize();
    return 0;
}
