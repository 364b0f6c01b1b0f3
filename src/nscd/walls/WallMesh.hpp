// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/search/BoxTree.hpp"
#include "nscd/walls/WallJoints.hpp"
#include "nscd/walls/WallMotion.hpp"

#include <algorithm>

namespace nscd
{

/// The nearest point of a facet.
template <int D>
struct Foot
{
    Vector<D> point;
    int joint;   ///< edge or corner it lies on; -1: inside the facet
};

/// On which sides of a plane something lies.
struct Sides
{
    bool above = false, below = false;

    bool none() const { return !above && !below; }
    bool lies(bool onTop) const { return onTop ? above : below; }
};

/// Segments or triangles, where they are now.
template <int D>
class WallMesh
{
public:
    WallMesh() = default;
    WallMesh(const std::vector<Facet<D>>& facets, const std::vector<int>& bodies);

    int facets() const { return static_cast<int>(normal_.size()); }

    Foot<D> nearest(int facet, const Vector<D>& x) const;

    /// Unit normal; a segment's is on the left of a -> b, and from there a triangle runs anticlockwise.
    const Vector<D>& normal(int facet) const { return normal_[facet]; }

    /// Height of a point above the plane of a facet [m].
    double height(int facet, const Vector<D>& x) const;

    /// The facets that meet in a joint, in the order of their numbers.
    struct Facets
    {
        const int *first, *last;

        const int* begin() const { return first; }
        const int* end() const { return last; }
        std::size_t size() const { return last - first; }
    };

    Facets facetsAt(int joint) const
    {
        const int* facets = joints_.facet.data();
        return {facets + joints_.facetBegin[joint], facets + joints_.facetBegin[joint + 1]};
    }

    /// Place of a facet among those that meet in a joint.
    std::size_t placeAt(int joint, int facet) const
    {
        const Facets facets = facetsAt(joint);
        return std::find(facets.begin(), facets.end(), facet) - facets.begin();
    }

    /// Sides of facet b's plane on which facet a lies, given their places at a joint; none if their planes are one.
    const Sides& sides(int joint, std::size_t a, std::size_t b) const
    {
        return sidesAt_[sidesBegin_[joint] + a * facetsAt(joint).size() + b];
    }

    /// Round-off of distances [m].
    double roundOff() const { return roundOff_; }

    Bounds<D> bounds(int facet) const;

    /// Go where the bodies are that have moved like this; body -1 stays.
    void move(const std::vector<RigidMotion<D>>& motions);

private:
    struct Side
    {
        Vector<D> inward;   ///< unit vector in the facet's plane, normal to its edge
        int corner, edge;
    };

    struct Edge
    {
        Vector<D> along;    ///< unit vector
        double length;
        int from;
    };

    void measureEdge(int edge);
    void measure(int facet);
    Sides measureSides(int a, int b, int joint) const;
    void measureAllSides();

    /// Numbers below n of what belongs to a body, given its corner.
    template <class Corner>
    std::vector<int> moving(std::size_t n, Corner&& cornerOf) const;

    WallJoints<D> joints_;
    std::vector<int> movingCorners_, movingEdges_, movingFacets_;
    Vectors<D> corner_;   ///< where they are now
    Vectors<D> normal_;
    std::vector<double> size_;   ///< greatest distance of corners from a facet's first [m]
    std::vector<Side> sides_;
    std::vector<Edge> edges_;
    std::vector<Sides> sidesAt_;            ///< of each joint: of each of its facets to each of them
    std::vector<std::size_t> sidesBegin_;   ///< of each joint
    double initialRoundOff_ = 0, roundOff_ = 0;
};

template <>
Foot<2> WallMesh<2>::nearest(int facet, const Vector<2>& x) const;
template <>
Foot<3> WallMesh<3>::nearest(int facet, const Vector<3>& x) const;

}  // namespace nscd
