// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/mesh/Polyhedron.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace overlap
{

Polyhedron::Polyhedron(const std::vector<Point3>& vertices, const std::vector<std::vector<int>>& faces)
{
    for (const Point3& v : vertices)
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
            if (k < 0 || k >= static_cast<int>(vertices.size()))
            {
                throw std::invalid_argument("Polyhedron: no vertex has the index " + std::to_string(k));
            }
            loop.push_back(vertices[k]);
        }
        facets_.addFace(loop.data(), loop.size(), &loops_);
    }
    if (faces.size() < 4) throw std::invalid_argument("Polyhedron: fewer than 4 faces");
    prepare();

    if (gap(facets_, faces_.data(), faces_.size()) > 1e-6)
    {
        throw std::invalid_argument("Polyhedron: the faces do not close");
    }
    if (!(shape_.volume > 0)) throw std::invalid_argument("Polyhedron: the volume is not positive");
}

Polyhedron::Polyhedron(Facets facets, std::vector<Point3> loops) : facets_(std::move(facets)), loops_(std::move(loops))
{
    prepare();
}

void Polyhedron::prepare()
{
    for (std::uint32_t face = 0; face < facets_.nFaces(); ++face) faces_.push_back({face, 1});
    if (!loops_.empty()) shape_ = cellShape(facets_, faces_.data(), faces_.size(), loops_.data(), loops_.size());
}

}  // namespace overlap
