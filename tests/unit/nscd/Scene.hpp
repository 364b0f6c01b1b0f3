// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Random.hpp"
#include "nscd/dynamics/ContactDynamics.hpp"

#include <algorithm>
#include <cstring>

constexpr double g = 9.81;

/// A scene in the making: unit mass and radius unless said otherwise, one material, a solver that converges.
template <int D>
struct Scene
{
    nscd::Grains<D> grains;
    nscd::Walls<D> walls;
    nscd::ContactTable table{2};
    nscd::Settings settings{1e-13, 200000, 0.5, 8};

    explicit Scene(double friction = 0, double restitution = 0)
    {
        table.set(0, 0, {friction, restitution});
        table.set(0, 1, {friction, restitution});
    }

    void add(const nscd::Vector<D>& x, const nscd::Vector<D>& v = nscd::Vector<D>::Zero(), double radius = 1,
             double mass = 1)
    {
        const std::size_t n = grains.size();
        grains.resize(n + 1);
        grains.id[n] = static_cast<std::int64_t>(n) + 100;
        grains.position[n] = x;
        grains.velocity[n] = v;
        grains.radius[n] = radius;
        grains.mass[n] = mass;
    }

    /// A wide floor at height 0 of material 1.
    void addFloor()
    {
        if constexpr (D == 2)
        {
            walls.push_back({{-1000, 0}, {1000, 0}, 1});
        }
        else
        {
            walls.push_back(nscd::Plane{{0, 0, 0}, {0, 0, 1}, 1});
        }
    }

    /// Walls around the box from the origin to 'size'.
    void addBox(const nscd::Vector<D>& size)
    {
        if constexpr (D == 2)
        {
            const nscd::Vector<2> a(0, 0), b(size.x(), 0), c(size), d(0, size.y());
            walls.insert(walls.end(), {{a, b, 1}, {b, c, 1}, {c, d, 1}, {d, a, 1}});
        }
        else
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                walls.push_back(nscd::Plane{nscd::Vector<3>::Zero(), nscd::Vector<3>::Unit(axis), 1});
                walls.push_back(nscd::Plane{size, -nscd::Vector<3>::Unit(axis), 1});
            }
        }
    }

    nscd::ContactDynamics<D> dynamics(MPI_Comm communicator = MPI_COMM_SELF) const
    {
        return {grains, walls, table, settings, communicator};
    }
};

/// One step under gravity [m/s^2] alone.
template <int D>
nscd::StepReport fall(nscd::ContactDynamics<D>& dynamics, const nscd::Vector<D>& gravity, double dt)
{
    nscd::Vectors<D> force;
    for (const double m : dynamics.grains().mass)
    {
        force.push_back(m * gravity);
    }
    return dynamics.step(force, nscd::Spins<D>(force.size(), nscd::Spin<D>::Zero()), dt);
}

/// Gravity seen from a floor that is inclined towards +x.
template <int D>
nscd::Vector<D> inclined(double angle)
{
    nscd::Vector<D> gravity = nscd::Vector<D>::Zero();
    gravity[0] = g * std::sin(angle);
    gravity[D - 1] = -g * std::cos(angle);
    return gravity;
}

template <int D>
nscd::Vector<D> up(double length = 1)
{
    return length * nscd::Vector<D>::Unit(D - 1);
}

/// Surface speed in +x at the foot of a grain on the floor due to its spin: minus the velocity it rolls with.
template <int D>
double rollingVelocity(const nscd::Grains<D>& grains, int i)
{
    return (D == 2 ? -grains.spin[i][0] : grains.spin[i][D == 2 ? 0 : 1]) * grains.radius[i];
}

template <int D>
double kineticEnergy(const nscd::Grains<D>& grains)
{
    double energy = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const double inertia = nscd::inertiaFactor<D> * grains.mass[i] * grains.radius[i] * grains.radius[i];
        energy += 0.5 * grains.mass[i] * grains.velocity[i].squaredNorm();
        energy += 0.5 * inertia * grains.spin[i].squaredNorm();
    }
    return energy;
}

template <class V>
bool sameBits(const std::vector<V>& a, const std::vector<V>& b)
{
    return a.size() == b.size() &&
           std::memcmp(static_cast<const void*>(a.data()), static_cast<const void*>(b.data()), a.size() * sizeof(V)) ==
               0;
}

/// Where wall bodies are and how they move; not their loads, which are the caller's.
template <int D>
bool sameMotion(const nscd::WallBody<D>& a, const nscd::WallBody<D>& b)
{
    return a.position == b.position && a.orientation.toRotationMatrix() == b.orientation.toRotationMatrix() &&
           a.velocity == b.velocity && a.spin == b.spin;
}

template <int D>
bool sameBits(const nscd::ContactDynamics<D>& a, const nscd::ContactDynamics<D>& b)
{
    const auto &x = a.wallBodies(), &y = b.wallBodies();
    return sameBits(a.grains().position, b.grains().position) && sameBits(a.grains().velocity, b.grains().velocity) &&
           sameBits(a.grains().orientation, b.grains().orientation) && sameBits(a.grains().spin, b.grains().spin) &&
           sameBits(a.contactImpulse(), b.contactImpulse()) &&
           sameBits(a.contactSpinImpulse(), b.contactSpinImpulse()) &&
           std::equal(x.begin(), x.end(), y.begin(), y.end(), sameMotion<D>) && a.worstOverlap() == b.worstOverlap() &&
           sameBits(a.unexpected().force, b.unexpected().force) &&
           sameBits(a.unexpected().torque, b.unexpected().torque) &&
           sameBits(a.owed().force, b.owed().force) && sameBits(a.owed().torque, b.owed().torque) &&
           sameBits(a.lasting().force, b.lasting().force) && sameBits(a.lasting().torque, b.lasting().torque) &&
           a.lastTimeStep() == b.lastTimeStep();
}

/// The same contacts in the same order; collective.
template <int D>
bool sameContacts(const nscd::ContactDynamics<D>& a, const nscd::ContactDynamics<D>& b)
{
    const auto x = a.contacts(), y = b.contacts();
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const auto& c, const auto& d)
                      { return c.first == d.first && c.second == d.second && c.force == d.force; });
}

/// The same that touched, in the same order; collective.
template <int D>
bool sameTouching(const nscd::ContactDynamics<D>& a, const nscd::ContactDynamics<D>& b)
{
    const auto x = a.touching(), y = b.touching();
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const auto& c, const auto& d)
                      {
                          return c.first == d.first && c.second == d.second && c.pressed == d.pressed &&
                                 c.impacts == d.impacts;
                      });
}

/// All but the times that the step took.
inline bool sameReport(const nscd::StepReport& a, const nscd::StepReport& b)
{
    return a.candidates == b.candidates && a.contacts == b.contacts && a.active == b.active &&
           a.subSteps == b.subSteps && a.sweeps == b.sweeps && a.solves == b.solves && a.converged == b.converged &&
           a.residual == b.residual && a.worstOverlap == b.worstOverlap && a.meanOverlap == b.meanOverlap &&
           a.maxVelocity == b.maxVelocity && a.contactWork == b.contactWork && a.impacts == b.impacts &&
           a.exhausted == b.exhausted;
}

/// Grains of unit size in a box, moving at random; 'perSide' along each axis.
template <int D>
Scene<D> agitated(int perSide, double friction, double speed = 3)
{
    Scene<D> scene(friction);
    nscd::Random random(7);
    const int n = D == 2 ? perSide * perSide : perSide * perSide * perSide;
    for (int i = 0; i < n; ++i)
    {
        const int cell[3] = {i % perSide, i / perSide % perSide, i / perSide / perSide};
        nscd::Vector<D> x, v;
        for (int d = 0; d < D; ++d)
        {
            x[d] = 2.2 * (cell[d] + 0.5) + random.uniform(-0.05, 0.05);
            v[d] = random.uniform(-speed, speed);
        }
        const double radius = random.uniform(0.8, 1);
        scene.add(x, v, radius, std::pow(radius, D));
    }
    scene.addBox(nscd::Vector<D>::Constant(2.2 * perSide));
    scene.settings.tolerance = 1e-6;
    scene.settings.maxSweeps = 60;
    return scene;
}
