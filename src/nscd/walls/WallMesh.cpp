// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/walls/WallMesh.hpp"

namespace nscd
{

namespace
{

/// Facets that lean against each other by less than about this angle [rad] are in one plane.
constexpr double flat = 1e-5;

/// Round-off of distances over the largest coordinate, with some room.
constexpr double relativeRoundOff = 1e-12;

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
    for (std::size_t e = 0; e < edges_.size(); ++e)
    {
        measureEdge(static_cast<int>(e));
    }
    for (int f = 0; f < this->facets(); ++f)
    {
        measure(f);
    }
    for (const Vector<D>& x : corner_)
    {
        initialRoundOff_ = std::max(initialRoundOff_, relativeRoundOff * x.cwiseAbs().maxCoeff());
    }
    roundOff_ = initialRoundOff_;
    measureAllSides();
    movingCorners_ = moving(corner_.size(), [](int c) { return c; });
    movingEdges_ = moving(edges_.size(), [this](int e) { return edges_[e].from; });
    movingFacets_ = moving(normal_.size(), [this](int f) { return sides_[joints_.sideBegin[f]].corner; });
}

template <int D>
template <class Corner>
std::vector<int> WallMesh<D>::moving(std::size_t n, Corner&& cornerOf) const
{
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(n); ++i)
    {
        if (joints_.body[cornerOf(i)] >= 0)
        {
            found.push_back(i);
        }
    }
    return found;
}

template <int D>
void WallMesh<D>::measureEdge(int edge)
{
    const auto& [from, to] = joints_.edge[edge];
    const Vector<D> along = corner_[to] - corner_[from];
    edges_[edge] = {along.normalized(), along.norm(), from};
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
void WallMesh<D>::measureAllSides()
{
    for (int joint = 0; joint + 1 < static_cast<int>(joints_.facetBegin.size()); ++joint)
    {
        sidesBegin_.push_back(sidesAt_.size());
        for (const int a : facetsAt(joint))
        {
            for (const int b : facetsAt(joint))
            {
                sidesAt_.push_back(measureSides(a, b, joint));
            }
        }
    }
}

template <int D>
Sides WallMesh<D>::measureSides(int a, int b, int joint) const
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
Bounds<D> WallMesh<D>::bounds(int facet) const
{
    const std::size_t begin = joints_.sideBegin[facet];
    Bounds<D> box{corner_[sides_[begin].corner], corner_[sides_[begin].corner]};
    for (std::size_t s = begin + 1; s < joints_.sideBegin[facet + 1]; ++s)
    {
        box.enclose({corner_[sides_[s].corner], corner_[sides_[s].corner]});
    }
    return box;
}

template <int D>
void WallMesh<D>::move(const std::vector<RigidMotion<D>>& motions)
{
    roundOff_ = initialRoundOff_;
    for (const int c : movingCorners_)
    {
        corner_[c] = motions[joints_.body[c]](joints_.corner[c]);
        roundOff_ = std::max(roundOff_, relativeRoundOff * corner_[c].cwiseAbs().maxCoeff());
    }
    for (const int e : movingEdges_)
    {
        measureEdge(e);
    }
    for (const int f : movingFacets_)
    {
        measure(f);
    }
}

template class WallMesh<2>;
template class WallMesh<3>;

}  // namespace nscd
