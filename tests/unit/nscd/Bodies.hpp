// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/problem/Delassus.hpp"

#include <limits>

/// Bodies and the points where they touch; body 0 is the fixed ground at the origin.
template <int D>
struct Bodies
{
    std::vector<nscd::RigidBody<D>> bodies;
    std::vector<nscd::ContactPoint<D>> contacts;

    Bodies() { bodies.push_back(body(nscd::Vector<D>::Zero(), 0, 0)); }

    static nscd::RigidBody<D> body(const nscd::Vector<D>& x, double inverseMass, double inverseInertia)
    {
        return {x, nscd::Vector<D>::Zero(), nscd::Spin<D>::Zero(), inverseMass,
                inverseInertia * nscd::SpinMatrix<D>::Identity()};
    }

    /// A solid disc or sphere; returns its number.
    int addGrain(const nscd::Vector<D>& x, double radius = 1, double mass = 1)
    {
        bodies.push_back(body(x, 1 / mass, 1 / (nscd::inertiaFactor<D> * mass * radius * radius)));
        return static_cast<int>(bodies.size()) - 1;
    }

    void accelerate(const nscd::Vector<D>& change)
    {
        for (auto& b : bodies)
        {
            b.velocity += b.inverseMass > 0 ? change : nscd::Vector<D>::Zero();
        }
    }

    /// Grains i and j touch in the middle.
    void touch(int i, int j, double friction)
    {
        const nscd::Vector<D> between = bodies[j].position - bodies[i].position;
        contacts.push_back({i, j, bodies[i].position + 0.5 * between, between.normalized(), 0, friction});
    }

    /// A body touches the horizontal ground at a point.
    void touchGround(int i, const nscd::Vector<D>& point, double friction)
    {
        contacts.push_back({0, i, point, nscd::Vector<D>::Unit(D - 1), 0, friction});
    }

    nscd::SparseProblem<D> problem() const { return nscd::delassus(bodies, contacts); }
};
