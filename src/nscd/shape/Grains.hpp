// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/shape/Cluster.hpp"

#include <cstdint>

namespace nscd
{

/// State of N grains: solid discs (2-D), spheres (3-D) or rigid clusters of them; entry i of every list belongs to
/// grain i.
/// The order of grains never changes during a run; `id` is what the user sees.
template <int D>
struct Grains
{
    std::vector<std::int64_t> id;
    Vectors<D> position;              ///< centres [m]
    Vectors<D> velocity;              ///< [m/s]
    Orientations<D> orientation;      ///< of the body's frame
    Spins<D> spin;                    ///< in space [rad/s]
    std::vector<int> shape;           ///< index into 'clusters'; -1: a disc or sphere
    std::vector<double> radius;       ///< [m], > 0; of a cluster that of the circle or sphere around it
    std::vector<double> mass;         ///< [kg], > 0; a disc's is that of its cylinder of the mesh's depth
    std::vector<int> material;        ///< index into the friction table
    std::vector<double> temperature;  ///< [K]

    std::vector<Cluster<D>> clusters; ///< shapes of the clusters among the grains

    std::size_t size() const { return position.size(); }

    void resize(std::size_t n)
    {
        id.resize(n);
        position.resize(n, Vector<D>::Zero());
        velocity.resize(n, Vector<D>::Zero());
        orientation.resize(n, Orientation<D>::Identity());
        spin.resize(n, Spin<D>::Zero());
        shape.resize(n, -1);
        radius.resize(n);
        mass.resize(n);
        material.resize(n, 0);
        temperature.resize(n, 0.0);
    }
};

}  // namespace nscd
