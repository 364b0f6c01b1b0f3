// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/mesh/CellTree.hpp"
#include "overlap/mesh/Polyhedron.hpp"

#include <vector>

namespace overlap
{

/// A mesh of polyhedral cells, prepared for the overlap with many balls: frames of faces, volumes, search.
///
/// The description is OpenFOAM's polyMesh: face f has the vertices faceVertices[faceStart[f]] to
/// faceVertices[faceStart[f + 1] - 1], counter-clockwise seen from outside its owner; faces with f < neighbour.size()
/// lie between owner[f] and neighbour[f], the others bound the mesh.  The mesh may be any part of a domain and need
/// not be connected.
class PolyhedralMesh
{
public:
    /// Throws std::invalid_argument, naming face or cell, if sizes do not fit, an index is out of range, a coordinate
    /// is not finite, or a cell does not close or has no positive volume.
    PolyhedralMesh(std::vector<Point3> points, std::vector<int> faceStart, std::vector<int> faceVertices,
                   std::vector<int> owner, std::vector<int> neighbour);

    /// The same mesh with its points elsewhere [m].  Throws as the constructor does.
    void movePoints(std::vector<Point3> points);

    std::size_t nCells() const { return shapes_.size(); }
    std::size_t nFaces() const { return owner_.size(); }

    double volume(std::size_t cell) const { return shapes_[cell].volume; }             ///< [m^3]
    const Point3& centroid(std::size_t cell) const { return shapes_[cell].centroid; }  ///< [m]

    CellView view(std::size_t cell) const { return {facets_, shapes_[cell], cellFaces(cell), nCellFaces(cell)}; }
    const Facets& facets() const { return facets_; }

    /// A cell by itself; its faces are the mesh's facets.
    Polyhedron polyhedron(std::size_t cell) const;
    const CellTree& tree() const { return tree_; }

    const CellFace* cellFaces(std::size_t cell) const { return cellFaces_.data() + cellFaceStart_[cell]; }
    std::size_t nCellFaces(std::size_t cell) const { return cellFaceStart_[cell + 1] - cellFaceStart_[cell]; }

    /// k-th vertex of a cell [m].
    const Point3& cellVertex(std::size_t cell, std::size_t k) const
    {
        return points_[cellVertices_[cellVertexStart_[cell] + k]];
    }
    std::size_t nCellVertices(std::size_t cell) const { return cellVertexStart_[cell + 1] - cellVertexStart_[cell]; }

private:
    void check() const;
    void connect();
    void prepare();

    std::vector<Point3> points_;
    std::vector<int> faceStart_, faceVertices_, owner_, neighbour_;

    std::vector<CellFace> cellFaces_;
    std::vector<std::size_t> cellFaceStart_, cellVertexStart_;
    std::vector<int> cellVertices_;

    Facets facets_;
    std::vector<CellShape> shapes_;
    CellTree tree_;
};

}  // namespace overlap
