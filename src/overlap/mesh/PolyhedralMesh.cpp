// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/mesh/PolyhedralMesh.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace overlap
{

namespace
{

[[noreturn]] void refuse(const std::string& what)
{
    throw std::invalid_argument("PolyhedralMesh: " + what);
}

bool isWithin(int i, std::size_t n)
{
    return i >= 0 && static_cast<std::size_t>(i) < n;
}

}  // namespace

PolyhedralMesh::PolyhedralMesh(std::vector<Point3> points, std::vector<int> faceStart, std::vector<int> faceVertices,
                               std::vector<int> owner, std::vector<int> neighbour)
    : points_(std::move(points)), faceStart_(std::move(faceStart)), faceVertices_(std::move(faceVertices)),
      owner_(std::move(owner)), neighbour_(std::move(neighbour))
{
    check();
    connect();
    prepare();
    tree_.build(shapes_);
}

void PolyhedralMesh::movePoints(std::vector<Point3> points)
{
    if (points.size() != points_.size())
    {
        refuse(std::to_string(points.size()) + " points for a mesh of " + std::to_string(points_.size()));
    }
    points_ = std::move(points);
    prepare();
    tree_.refit(shapes_);
}

void PolyhedralMesh::check() const
{
    const std::size_t n = owner_.size();
    if (faceStart_.size() != n + 1 || faceStart_[0] != 0 || faceStart_[n] != static_cast<int>(faceVertices_.size()))
    {
        refuse(
            "faceStart does not begin with 0, end with the number of faceVertices and have one entry more than owner");
    }
    if (neighbour_.size() > n) refuse("more neighbours than owners");
    for (std::size_t f = 0; f < n; ++f)
    {
        const auto refuseFace = [f](const std::string& what) { refuse("face " + std::to_string(f) + what); };
        if (faceStart_[f + 1] - faceStart_[f] < 3) refuseFace(" has fewer than 3 vertices");
        if (owner_[f] < 0) refuseFace(" has the owner " + std::to_string(owner_[f]));
        if (f < neighbour_.size() && (neighbour_[f] < 0 || neighbour_[f] == owner_[f]))
        {
            refuseFace(" has the neighbour " + std::to_string(neighbour_[f]));
        }
    }
    for (const int k : faceVertices_)
    {
        if (!isWithin(k, points_.size())) refuse("no point has the index " + std::to_string(k));
    }
}

void PolyhedralMesh::connect()
{
    int last = -1;
    for (const int cell : owner_) last = std::max(last, cell);
    for (const int cell : neighbour_) last = std::max(last, cell);
    const std::size_t n = static_cast<std::size_t>(last + 1);

    cellFaceStart_.assign(n + 1, 0);
    for (const int cell : owner_) ++cellFaceStart_[cell + 1];
    for (const int cell : neighbour_) ++cellFaceStart_[cell + 1];
    for (std::size_t c = 0; c < n; ++c) cellFaceStart_[c + 1] += cellFaceStart_[c];

    cellFaces_.resize(cellFaceStart_[n]);
    std::vector<std::size_t> place(cellFaceStart_.begin(), cellFaceStart_.end() - 1);
    for (std::size_t f = 0; f < owner_.size(); ++f)
    {
        cellFaces_[place[owner_[f]]++] = {static_cast<std::uint32_t>(f), 1};
        if (f < neighbour_.size()) cellFaces_[place[neighbour_[f]]++] = {static_cast<std::uint32_t>(f), -1};
    }

    cellVertexStart_.assign(1, 0);
    std::vector<int> vertices;
    for (std::size_t c = 0; c < n; ++c)
    {
        vertices.clear();
        for (std::size_t i = 0; i < nCellFaces(c); ++i)
        {
            const std::uint32_t f = cellFaces(c)[i].face;
            vertices.insert(vertices.end(), faceVertices_.begin() + faceStart_[f],
                            faceVertices_.begin() + faceStart_[f + 1]);
        }
        if (vertices.empty()) refuse("cell " + std::to_string(c) + " has no faces");
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        cellVertices_.insert(cellVertices_.end(), vertices.begin(), vertices.end());
        cellVertexStart_.push_back(cellVertices_.size());
    }
    shapes_.resize(n);
}

Polyhedron PolyhedralMesh::polyhedron(std::size_t cell) const
{
    Facets facets;
    std::vector<Point3> vertices, loops;
    for (std::size_t i = 0; i < nCellFaces(cell); ++i)
    {
        const auto [face, sign] = cellFaces(cell)[i];
        vertices.clear();
        for (int k = faceStart_[face]; k < faceStart_[face + 1]; ++k) vertices.push_back(points_[faceVertices_[k]]);
        if (sign < 0) std::reverse(vertices.begin(), vertices.end());
        facets.addFace(vertices.data(), vertices.size(), &loops);
    }
    return Polyhedron(std::move(facets), std::move(loops));
}

void PolyhedralMesh::prepare()
{
    for (std::size_t k = 0; k < points_.size(); ++k)
    {
        if (!isFinite(points_[k])) refuse("point " + std::to_string(k) + " is not finite");
    }

    facets_.clear();
    std::vector<Point3> vertices;
    for (std::size_t f = 0; f < nFaces(); ++f)
    {
        vertices.clear();
        for (int k = faceStart_[f]; k < faceStart_[f + 1]; ++k) vertices.push_back(points_[faceVertices_[k]]);
        facets_.addFace(vertices.data(), vertices.size());
    }

    for (std::size_t c = 0; c < nCells(); ++c)
    {
        vertices.clear();
        for (std::size_t k = 0; k < nCellVertices(c); ++k) vertices.push_back(cellVertex(c, k));
        shapes_[c] = cellShape(facets_, cellFaces(c), nCellFaces(c), vertices.data(), vertices.size());
        if (gap(facets_, cellFaces(c), nCellFaces(c)) > 1e-6) refuse("cell " + std::to_string(c) + " does not close");
        if (!(shapes_[c].volume > 0)) refuse("the volume of cell " + std::to_string(c) + " is not positive");
    }
}

}  // namespace overlap
