// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/WallMesh.hpp"

#include <algorithm>

namespace nscd
{

namespace
{

/// Facets that lean against each other by less than about this angle [rad] are in one plane.
constexpr double flat = 1e-5;

}  // namespace

template <int D>
WallMesh<D>::WallMesh(const std::vector<Facet<D>>& facets, const std::vector<int>& bodies)
    : joints_(facets, bodies), corner_(joints_.corner), normal_(facets.size()), size_(facets.size()),
      edges_(joints_.edge.size())
{
    for (const FacetSide& side : joints_.side)
    {
        sides_.push_back({Vector<D>::Zero(), side.corner, side.edge});
    }
    measureEdges();
    for (int f = 0; f < this->facets(); ++f)
    {
        measure(f);
    }
}

template <int D>
void WallMesh<D>::measureEdges()
{
    roundOff_ = 0;
    for (const Vector<D>& x : corner_)
    {
        roundOff_ = std::max(roundOff_, 1e-12 * x.cwiseAbs().maxCoeff());
    }
    for (std::size_t e = 0; e < edges_.size(); ++e)
    {
        const auto& [from, to] = joints_.edge[e];
        const Vector<D> edge = corner_[to] - corner_[from];
        edges_[e] = {edge.normalized(), edge.norm(), from};
    }
}

template <>
void WallMesh<2>::measure(int facet)
{
    Side& a = sides_[joints_.sideBegin[facet]];
    Side& b = sides_[joints_.sideBegin[facet] + 1];
    a.inward = (corner_[b.corner] - corner_[a.corner]).normalized();
    size_[facet] = (corner_[b.corner] - corner_[a.corner]).norm();
    b.inward = -a.inward;
    normal_[facet] = Vector<2>(-a.inward.y(), a.inward.x());
}

template <>
void WallMesh<3>::measure(int facet)
{
    const std::size_t begin = joints_.sideBegin[facet];
    const std::size_t end = joints_.sideBegin[facet + 1];
    const Vector<3>& first = corner_[sides_[begin].corner];
    Vector<3> area = Vector<3>::Zero();
    size_[facet] = 0;
    for (std::size_t s = begin + 1; s < end; ++s)
    {
        size_[facet] = std::max(size_[facet], (corner_[sides_[s].corner] - first).norm());
    }
    for (std::size_t s = begin + 1; s + 1 < end; ++s)
    {
        area += (corner_[sides_[s].corner] - first).cross(corner_[sides_[s + 1].corner] - first);
    }
    normal_[facet] = area.normalized();
    for (std::size_t s = begin; s < end; ++s)
    {
        const Edge& edge = edges_[sides_[s].edge];
        const double forward = edge.from == sides_[s].corner ? 1 : -1;
        sides_[s].inward = forward * normal_[facet].cross(edge.along);
    }
}

template <int D>
double WallMesh<D>::height(int facet, const Vector<D>& x) const
{
    return normal_[facet].dot(x - corner_[sides_[joints_.sideBegin[facet]].corner]);
}

template <>
Foot<2> WallMesh<2>::nearest(int facet, const Vector<2>& x) const
{
    for (std::size_t s = joints_.sideBegin[facet]; s < joints_.sideBegin[facet + 1]; ++s)
    {
        const Vector<2>& end = corner_[sides_[s].corner];
        if ((x - end).dot(sides_[s].inward) <= roundOff_)
        {
            return {end, sides_[s].corner};
        }
    }
    return {x - height(facet, x) * normal_[facet], -1};
}

template <>
Foot<3> WallMesh<3>::nearest(int facet, const Vector<3>& x) const
{
    bool inside = true;
    int corner = -1;
    double shortest = 0;
    for (std::size_t s = joints_.sideBegin[facet]; s < joints_.sideBegin[facet + 1]; ++s)
    {
        const Side& side = sides_[s];
        const Vector<3> toX = x - corner_[side.corner];
        if (toX.dot(side.inward) <= roundOff_)
        {
            inside = false;
            const Edge& edge = edges_[side.edge];
            const double along = (x - corner_[edge.from]).dot(edge.along);
            if (along > roundOff_ && along < edge.length - roundOff_)
            {
                return {corner_[edge.from] + along * edge.along, joints_.jointOf(side.edge)};
            }
        }
        const double square = toX.squaredNorm();
        if (corner < 0 || square < shortest)
        {
            corner = side.corner;
            shortest = square;
        }
    }
    if (inside)
    {
        return {x - height(facet, x) * normal_[facet], -1};
    }
    return {corner_[corner], corner};
}

template <int D>
Sides WallMesh<D>::sides(int a, int b, int joint) const
{
    const int corners = static_cast<int>(corner_.size());
    const Vector<D>& from = corner_[joint < corners ? joint : edges_[joint - corners].from];
    const double same = flat * size_[a];
    Sides sides;
    for (std::size_t s = joints_.sideBegin[a]; s < joints_.sideBegin[a + 1]; ++s)
    {
        const double height = normal_[b].dot(corner_[sides_[s].corner] - from);
        sides.above = sides.above || height > same;
        sides.below = sides.below || height < -same;
    }
    return sides;
}

template <int D>
std::vector<Bounds<D>> WallMesh<D>::bounds() const
{
    std::vector<Bounds<D>> boxes;
    for (int f = 0; f < facets(); ++f)
    {
        const std::size_t begin = joints_.sideBegin[f];
        Bounds<D> box{corner_[sides_[begin].corner], corner_[sides_[begin].corner]};
        for (std::size_t s = begin + 1; s < joints_.sideBegin[f + 1]; ++s)
        {
            box.enclose({corner_[sides_[s].corner], corner_[sides_[s].corner]});
        }
        boxes.push_back(box);
    }
    return boxes;
}

template <int D>
void WallMesh<D>::move(const std::vector<RigidMotion<D>>& motions)
{
    for (std::size_t c = 0; c < corner_.size(); ++c)
    {
        if (joints_.body[c] >= 0)
        {
            corner_[c] = motions[joints_.body[c]](joints_.corner[c]);
        }
    }
    measureEdges();
    for (int f = 0; f < facets(); ++f)
    {
        if (joints_.body[sides_[joints_.sideBegin[f]].corner] >= 0)
        {
            measure(f);
        }
    }
}

template <int D>
double WallMesh<D>::farthestMove(const std::vector<RigidMotion<D>>& before,
                                 const std::vector<RigidMotion<D>>& after) const
{
    double farthest = 0;
    for (std::size_t c = 0; c < corner_.size(); ++c)
    {
        const int body = joints_.body[c];
        if (body >= 0)
        {
            const Vector<D>& x = joints_.corner[c];
            farthest = std::max(farthest, (after[body](x) - before[body](x)).squaredNorm());
        }
    }
    return std::sqrt(farthest);
}

template class WallMesh<2>;
template class WallMesh<3>;

}  // namespace nscd
