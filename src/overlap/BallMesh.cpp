// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/BallMesh.hpp"

#include "overlap/CellSum.hpp"

namespace overlap
{

BallMesh::BallMesh(const PolyhedralMesh& mesh) : mesh_(mesh), place_(mesh.nFaces()), ballOf_(mesh.nFaces(), 0) {}

const std::vector<CellOverlap>& BallMesh::overlaps(const Point3& centre, double radius)
{
    ball_ = unitBall(centre, radius);
    overlaps_.clear();
    faces_.clear();
    if (++ballNumber_ == 0)
    {
        std::fill(ballOf_.begin(), ballOf_.end(), 0);
        ballNumber_ = 1;
    }

    bool isNear = false;
    const auto addCovered = [&](int cell)
    {
        overlaps_.push_back({{mesh_.volume(cell), mesh_.centroid(cell), 0, Point3::Zero()}, cell, true});
        return true;
    };
    const auto addPart = [&](int cell)
    {
        const auto vertex = [&](std::size_t k) -> const Point3& { return mesh_.cellVertex(cell, k); };
        if (covers(centre, radius, mesh_.nCellVertices(cell), vertex)) return addCovered(cell);

        Source source{*this};
        CellSum<Source> sum(ball_, mesh_.view(cell), source);
        const BallOverlap part = sum.overlap();
        if (part.volume > 0) overlaps_.push_back({part, cell, false});
        isNear = isNear || sum.isNear();
        return !sum.holdsBall();
    };
    mesh_.tree().forCells(centre, radius, addCovered, addPart);

    // The two forms agree to the rounding of the cells' coordinates, which can be many digits of a small ball: take
    // one of them for all cells, whose sum then does not depend on it
    if (isNear) useOuterForm();
    return overlaps_;
}

void BallMesh::useOuterForm()
{
    for (CellOverlap& part : overlaps_)
    {
        if (part.covered) continue;
        using Sum = CellSum<Source>;
        Source source{*this};
        static_cast<BallOverlap&>(part) = Sum(ball_, mesh_.view(part.cell), source).overlap(Sum::Form::outer);
    }
    const auto isEmpty = [](const CellOverlap& part) { return part.volume == 0; };
    overlaps_.erase(std::remove_if(overlaps_.begin(), overlaps_.end(), isEmpty), overlaps_.end());
}

double BallMesh::faceArea(int face)
{
    return parts(face).area * ball_.radius * ball_.radius;
}

BallMesh::Face& BallMesh::find(std::size_t face)
{
    if (ballOf_[face] != ballNumber_)
    {
        ballOf_[face] = ballNumber_;
        place_[face] = static_cast<std::uint32_t>(faces_.size());
        faces_.push_back({heightRange(ball_, mesh_.facets(), face), false, FaceParts()});
    }
    return faces_[place_[face]];
}

const FaceParts& BallMesh::parts(std::size_t face)
{
    Face& found = find(face);
    if (!found.hasParts)
    {
        found.parts = innerParts(ball_, mesh_.facets(), face);
        found.hasParts = true;
    }
    return found.parts;
}

}  // namespace overlap
