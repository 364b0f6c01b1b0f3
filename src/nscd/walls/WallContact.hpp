// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/walls/WallMesh.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace nscd
{

/// Where two bodies are nearest to each other.
template <int D>
struct Approach
{
    Vector<D> normal;   ///< from the first to the second, of unit length
    double gap;         ///< [m], negative when they overlap
};

/// How a grain meets walls, fixed or moving.
///
/// A half space is met by its plane.  A segment or triangle - a facet - is met at its point nearest to the grain's
/// centre, from either side.  Facets of the same body (-1 is one of them) that share a corner or an edge are one
/// surface.  When the nearest point lies on such a joint:
///  - Flat or convex joint: where no facet of the joint has a nearer point, the joint is one contact, which the facet
///    with the lowest number carries; otherwise the contact is left to the nearer facets.
///  - Concave joint: a facet that forms a hollow with the facets between it and the grain, the grain inside, is
///    continued beyond the joint, so that a fast grain meets it in time.  The grain must be above one of these facets
///    and not yet touch the continued one.  (A facet behind a ridge is not met.)
///
/// So a grain that rolls over flat or convex joints always has one contact, in a concave angle one with either side.
/// The same holds where corners lie on the free edge of a neighbour.  An edge that stands in the middle of another
/// facet is no joint: a grain that approaches it also has a contact with that edge, as long as the edge is the nearest
/// point of its facet.  A grain that rolls from the walls of one body to those of another feels the edges between them.
///
/// In a periodic box a facet is met by the image of the grain that is nearest to it; a facet longer than the period
/// must be parallel to its axis.  Facets that meet across the period are one surface, too; those of a body that has
/// turned only about the period's axis.
template <int D>
class WallContact
{
public:
    /// The walls must have passed validate().  'period': lengths of the periodic box [m], 0 where it is not periodic.
    explicit WallContact(const Walls<D>& walls, const std::array<double, 3>& period = {});

    /// Nothing when other facets speak for this one.
    std::optional<Approach<D>> approach(int wall, const Vector<D>& centre, double radius) const;

    /// Is the plane of a wall farther than 'reach' >= 0 [m] from x, so that no contact of a ball around x can be
    /// nearer?  A quick answer: false where it is not known, as in a periodic box.
    bool isBeyond(int wall, const Vector<D>& x, double reach) const;

    /// Distance of a point to the nearest point of a wall [m]; negative inside a half space.
    double distance(int wall, const Vector<D>& x) const;

    /// From a point to the nearest point of a wall [m].
    Vector<D> way(int wall, const Vector<D>& x) const;

    /// The periodic image of x that is nearest to a facet; half spaces have none.
    Vector<D> image(int wall, const Vector<D>& x) const;

    /// Does a facet stand between x and x + way?  Of half spaces all bodies are on one side.
    bool separates(const Vector<D>& x, const Vector<D>& way) const;

    /// Call f(wall) for every wall nearer to x than 'reach' [m], always in the same order.
    template <class F>
    void forNear(const Vector<D>& x, double reach, F&& f) const;

    /// Move the walls with their bodies, from where they were given with the bodies at 'initial'.
    /// Throws std::invalid_argument when a body with a plane has turned.
    void place(const std::vector<WallBody<D>>& initial, const std::vector<WallBody<D>>& now);

private:
    struct HalfSpace
    {
        Vector<D> initialPoint, point, normal;
        int wall;
    };

    /// Finds facets by their boxes.
    struct Search
    {
        std::vector<int> facets;
        BoxTree<D> tree;
    };

    /// A facet's image in the next period, which stands in the mesh after all facets: what it is to its neighbours.
    struct Image
    {
        int facet;
        Vector<D> shift;   ///< from the facet to the image [m]
    };

    /// Images of facets that touch a facet.
    void makeImages(std::vector<Facet<D>>& facets, std::vector<int>& bodies);

    bool isImage(int facet) const { return facet >= static_cast<int>(wallOf_.size()); }
    const Image& imageOf(int facet) const { return images_[facet - wallOf_.size()]; }

    /// Has the body of an image turned, so that it is not where the neighbour in the next period is?
    bool isAstray(int facet) const;

    std::vector<Bounds<D>> bounds(const std::vector<int>& facets) const;
    double height(const HalfSpace& halfSpace, const Vector<D>& x) const;
    Vector<D> imageNearFacet(int facet, const Vector<D>& x) const;
    std::optional<Approach<D>> approachFacet(int facet, const Vector<D>& centre, double radius) const;

    template <class F>
    void forNearFacets(const Vector<D>& x, double reach, F&& f) const;
    Approach<D> approachPlane(int facet, const Vector<D>& centre, double radius) const;
    Approach<D> approachJoint(int facet, const Vector<D>& point, const Vector<D>& centre, double radius) const;

    /// What the other facets of a joint are to a facet whose nearest point to x lies there.
    struct Company
    {
        int nearest = -1;      ///< one that has a nearer point; of those in a hollow, the nearest; -1: none
        bool first = true;     ///< are all others that end there of higher numbers?
        bool hollow = true;    ///< do all nearer ones lean towards the facet, as seen from x?
    };

    /// With 'flat', facets in one plane make a hollow too.
    Company company(int facet, int joint, const Vector<D>& x, bool flat) const;

    /// Does x lie above a facet, or above one to which a hollow leads from there?
    bool inHollow(int facet, Vector<D> x) const;

    std::array<double, 3> period_;
    bool periodic_;
    std::vector<int> body_;                ///< of each wall
    std::vector<int> facetOf_;             ///< of each wall; half space h: ~h
    std::vector<int> wallOf_;              ///< of each facet
    std::vector<HalfSpace> halfSpaces_;
    std::vector<Image> images_;
    WallMesh<D> mesh_;
    Search fixed_, moving_;
    std::vector<RigidMotion<D>> motions_;  ///< of the bodies when the walls were last moved
};

template <int D>
template <class F>
void WallContact<D>::forNear(const Vector<D>& x, double reach, F&& f) const
{
    for (const HalfSpace& halfSpace : halfSpaces_)
    {
        if (height(halfSpace, x) < reach)
        {
            f(halfSpace.wall);
        }
    }
    const auto isNear = [&](int facet, const Vector<D>& image)
    { return (mesh_.nearest(facet, image).point - image).squaredNorm() < reach * reach; };
    if (!periodic_)
    {
        forNearFacets(x, reach,
                      [&](int facet)
                      {
                          if (isNear(facet, x))
                          {
                              f(wallOf_[facet]);
                          }
                      });
        return;
    }
    std::vector<int> found;
    Vectors<D> images{x};
    for (int d = 0; d < D; ++d)
    {
        if (period_[d] > 0)
        {
            for (std::size_t own = images.size(), i = 0; i < own; ++i)
            {
                images[i][d] -= period_[d] * std::floor(images[i][d] / period_[d]);
                images.insert(images.end(), 2, images[i]);
                images[images.size() - 2][d] -= period_[d];
                images.back()[d] += period_[d];
            }
        }
    }
    for (const Vector<D>& image : images)
    {
        forNearFacets(image, reach, [&](int facet) { found.push_back(facet); });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const int facet : found)
    {
        if (isNear(facet, imageNearFacet(facet, x)))
        {
            f(wallOf_[facet]);
        }
    }
}

template <int D>
template <class F>
void WallContact<D>::forNearFacets(const Vector<D>& x, double reach, F&& f) const
{
    const Vector<D> margin = Vector<D>::Constant(reach);
    for (const Search* search : {&fixed_, &moving_})
    {
        search->tree.forMeeting({x - margin, x + margin}, [&](int i) { f(search->facets[i]); });
    }
}

extern template class WallContact<2>;
extern template class WallContact<3>;

}  // namespace nscd
