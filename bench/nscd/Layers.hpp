// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Random.hpp"
#include "nscd/packing/Packing.hpp"

#include <cmath>

/// A box of grains of 0.9 to 1 mm radius, and their weight.
template <int D>
struct Layers
{
    nscd::Grains<D> grains;
    nscd::Walls<D> walls;
    nscd::Vectors<D> weight;

    /// This many grains on a loose lattice, so many layers deep, with small random velocities.
    Layers(std::size_t count, int layers)
    {
        const double r = 1e-3;
        const double pitch = 2.05 * r;
        const double perLayer = static_cast<double>(count) / layers;
        const double side = pitch * std::ceil(D == 2 ? perLayer : std::sqrt(perLayer));
        nscd::Box<D> box;
        box.lower.setZero();
        box.upper.setConstant(side + 0.5 * r);
        box.upper[D - 1] = pitch * layers * 1.2;
        if constexpr (D == 2)
        {
            const nscd::Vector<2> a(0, 0), b(box.upper.x(), 0), c(box.upper), d(0, box.upper.y());
            walls = {{a, b}, {b, c}, {d, a}};
        }
        else
        {
            walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::UnitZ()});
            for (int axis = 0; axis < 2; ++axis)
            {
                walls.push_back(nscd::Plane{box.lower, nscd::Vector<3>::Unit(axis)});
                walls.push_back(nscd::Plane{box.upper, -nscd::Vector<3>::Unit(axis)});
            }
        }
        const nscd::Vectors<D> centres = nscd::lattice<D>(box, r, pitch);
        grains.resize(std::min(count, centres.size()));
        nscd::Random random(1);
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            grains.id[i] = static_cast<std::int64_t>(i);
            grains.position[i] = centres[i];
            grains.radius[i] = r * random.uniform(0.9, 1);
            grains.mass[i] = 2500 * std::pow(grains.radius[i], D);
            for (int d = 0; d < D; ++d)
            {
                grains.velocity[i][d] = random.uniform(-0.05, 0.05);
            }
            weight.push_back(-9.81 * grains.mass[i] * nscd::Vector<D>::Unit(D - 1));
        }
    }
};
