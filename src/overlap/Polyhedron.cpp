// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/Polyhedron.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace overlap
{

Polyhedron::Polyhedron(const std::vector<Point3>& vertices, const std::vector<std::vector<int>>& faces)
    : vertices_(vertices)
{
    for (const Point3& v : vertices_)
    {
        if (!isFinite(v)) throw std::invalid_argument("Polyhedron: a vertex is not finite");
    }

    std::vector<Point3> loop;
    for (const std::vector<int>& face : faces)
    {
        if (face.size() < 3) throw std::invalid_argument("Polyhedron: a face has fewer than 3 vertices");
        loop.clear();
        for (const int k : face)
        {
            if (k < 0 || k >= static_cast<int>(vertices_.size()))
            {
                throw std::invalid_argument("Polyhedron: no vertex has the index " + std::to_string(k));
            }
            loop.push_back(vertices_[k]);
        }
        faces_.push_back({static_cast<std::uint32_t>(faces_.size()), 1});
        facets_.addFace(loop.data(), loop.size());
    }
    if (faces_.size() < 4) throw std::invalid_argument("Polyhedron: fewer than 4 faces");

    if (gap(facets_, faces_.data(), faces_.size()) > 1e-6)
    {
        throw std::invalid_argument("Polyhedron: the faces do not close");
    }
    shape_ = cellShape(facets_, faces_.data(), faces_.size(), vertices_.data(), vertices_.size());
    if (!(shape_.volume > 0)) throw std::invalid_argument("Polyhedron: the volume is not positive");
}

}  // namespace overlap
