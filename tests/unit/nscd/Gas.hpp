// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Scene.hpp"

/// Equal grains of unit mass and radius on a lattice in a periodic cube, with random velocities of zero sum, in each
/// component of unit mean square before that is taken away.
template <int D>
struct Gas
{
    Gas(int perSide, double spacing, std::uint64_t seed, double speed = 1) : side(spacing * perSide)
    {
        nscd::Random random(seed);
        const int n = D == 2 ? perSide * perSide : perSide * perSide * perSide;
        nscd::Vector<D> mean = nscd::Vector<D>::Zero();
        for (int i = 0; i < n; ++i)
        {
            const int cell[3] = {i % perSide, i / perSide % perSide, i / perSide / perSide};
            nscd::Vector<D> x, v;
            for (int d = 0; d < D; ++d)
            {
                x[d] = spacing * (cell[d] + 0.5);
                v[d] = speed * random.uniform(-std::sqrt(3), std::sqrt(3));
            }
            mean += v / n;
            scene.add(x, v);
        }
        for (auto& v : scene.grains.velocity)
        {
            v -= mean;
        }
        scene.settings.tolerance = 1e-9;
        std::fill_n(scene.settings.period.begin(), D, side);
    }

    Scene<D> scene;
    double side;   ///< [m]
};
