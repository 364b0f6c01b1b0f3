// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/ball/BallMesh.hpp"

#include "overlap/ball/BallPolyhedron.hpp"
#include "overlap/ball/CellSum.hpp"
#include "overlap/clip/Clip.hpp"

namespace overlap
{

BallMesh::BallMesh(const PolyhedralMesh& mesh) : mesh_(mesh), faces_(mesh.nFaces()) {}

const std::vector<CellOverlap>& BallMesh::overlaps(const Point3& centre, double radius, int hint)
{
    ball_ = unitBall(centre, radius);
    overlaps_.clear();
    parts_.clear();
    if (++ballNumber_ == 0)
    {
        faces_.assign(faces_.size(), Face());
        ballNumber_ = 1;
    }
    if (hint >= 0 && static_cast<std::size_t>(hint) < mesh_.nCells() && holdsBall(hint))
    {
        overlaps_.push_back({wholeBall(ball_), hint, false});
        return overlaps_;
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
        const CellView view = mesh_.view(cell);
        if (covers(centre, radius, view.shape, mesh_.nCellVertices(cell), vertex)) return addCovered(cell);

        Source source{*this};
        CellSum<Source> sum(ball_, view, source);
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

const std::vector<CellOverlap>& BallMesh::overlaps(const Point3& centre, double radius,
                                                   const std::vector<HalfSpace<3>>& halfSpaces)
{
    overlaps(centre, radius);
    for (CellOverlap& part : overlaps_) cut(part, halfSpaces);
    removeEmpty();
    return overlaps_;
}

void BallMesh::cut(CellOverlap& part, const std::vector<HalfSpace<3>>& halfSpaces) const
{
    const CellShape& shape = mesh_.view(part.cell).shape;
    const Point3 middle = 0.5 * (shape.low + shape.high), half = 0.5 * (shape.high - shape.low);
    std::vector<const HalfSpace<3>*> cutting;
    for (const HalfSpace<3>& halfSpace : halfSpaces)
    {
        const double distance = halfSpace.distance(middle), reach = halfSpace.normal.cwiseAbs().dot(half);
        if (distance <= -reach) continue;
        if (distance >= reach)
        {
            part.volume = 0;
            return;
        }
        cutting.push_back(&halfSpace);
    }
    if (cutting.empty()) return;

    Polyhedron cell = mesh_.polyhedron(part.cell);
    for (const HalfSpace<3>* halfSpace : cutting) cell = clipped(cell, *halfSpace);
    static_cast<BallOverlap&>(part) = ballPolyhedron(ball_.centre, ball_.radius, cell);
}

void BallMesh::removeEmpty()
{
    const auto isEmpty = [](const CellOverlap& part) { return part.volume == 0; };
    overlaps_.erase(std::remove_if(overlaps_.begin(), overlaps_.end(), isEmpty), overlaps_.end());
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

bool BallMesh::holdsBall(int cell)
{
    const CellView view = mesh_.view(cell);
    for (std::size_t i = 0; i < view.nFaces; ++i)
    {
        const auto [low, high] = face(view.faces[i].face).heights;
        if ((view.faces[i].sign > 0 ? low : -high) < 1) return false;
    }
    return true;
}

BallMesh::Face& BallMesh::face(std::size_t i)
{
    Face& found = faces_[i];
    if (found.ball != ballNumber_) found = {ballNumber_, -1, heightRange(ball_, mesh_.facets(), i)};
    return found;
}

const FaceParts& BallMesh::parts(std::size_t i)
{
    Face& found = face(i);
    if (found.parts < 0)
    {
        found.parts = static_cast<std::int32_t>(parts_.size());
        parts_.push_back(innerParts(ball_, mesh_.facets(), i));
    }
    return parts_[found.parts];
}

}  // namespace overlap
