// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/Types.hpp"

#include <cstdint>

namespace nscd
{

/// State of N solid discs (2-D) or spheres (3-D); entry i of every list belongs to grain i.
/// The order of grains never changes during a run; `id` is what the user sees.
template <int D>
struct Grains
{
    std::vector<std::int64_t> id;
    Vectors<D> position;              ///< centres [m]
    Vectors<D> velocity;              ///< [m/s]
    Spins<D> spin;                    ///< [rad/s]
    std::vector<double> radius;       ///< [m], > 0
    std::vector<double> mass;         ///< [kg], > 0; a disc's is that of its cylinder of the mesh's depth
    std::vector<int> material;        ///< index into the friction table
    std::vector<double> temperature;  ///< [K]

    std::size_t size() const { return position.size(); }

    void resize(std::size_t n)
    {
        id.resize(n);
        position.resize(n, Vector<D>::Zero());
        velocity.resize(n, Vector<D>::Zero());
        spin.resize(n, Spin<D>::Zero());
        radius.resize(n);
        mass.resize(n);
        material.resize(n, 0);
        temperature.resize(n, 0.0);
    }
};

}  // namespace nscd
