// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

/// A hexahedron (8 vertices) or tetrahedron (4) as the package overlap sees it.
class Peer
{
public:
    virtual ~Peer() = default;
    virtual double volume(const Eigen::Vector3d& centre, double radius) const = 0;
};

/// Null if the package was not there when this was built.
std::unique_ptr<Peer> makePeer(const std::vector<Eigen::Vector3d>& vertices);
