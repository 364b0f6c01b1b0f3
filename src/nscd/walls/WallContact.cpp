// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/walls/WallContact.hpp"

#include "nscd/base/Check.hpp"

namespace nscd
{

namespace
{

Facet<2> cornersOf(const Segment& wall)
{
    return {wall.a, wall.b};
}

Facet<3> cornersOf(const std::variant<Plane, Triangle>& wall)
{
    const Triangle& triangle = std::get<Triangle>(wall);
    return {triangle.a, triangle.b, triangle.c};
}

template <int D>
Bounds<D> boundsOf(const Facet<D>& facet)
{
    Bounds<D> box{facet[0], facet[0]};
    for (const Vector<D>& corner : facet)
    {
        box.enclose({corner, corner});
    }
    return box;
}

const Plane* planeOf(const std::variant<Plane, Triangle>& wall)
{
    return std::get_if<Plane>(&wall);
}

}  // namespace

template <int D>
WallContact<D>::WallContact(const Walls<D>& walls, const std::array<double, 3>& period)
    : period_(period), periodic_(*std::max_element(period.begin(), period.end()) > 0)
{
    std::vector<Facet<D>> facets;
    std::vector<int> facetBody;
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        const int wall = static_cast<int>(w);
        body_.push_back(bodyOf(walls[w]));
        if constexpr (D == 3)
        {
            if (const Plane* plane = planeOf(walls[w]))
            {
                facetOf_.push_back(~static_cast<int>(halfSpaces_.size()));
                halfSpaces_.push_back({plane->point, plane->point, plane->normal, wall});
                continue;
            }
        }
        facetOf_.push_back(static_cast<int>(facets.size()));
        wallOf_.push_back(wall);
        facets.push_back(cornersOf(walls[w]));
        facetBody.push_back(body_.back());
    }
    makeImages(facets, facetBody);
    mesh_ = WallMesh<D>(facets, facetBody);
    std::vector<int> movingBody;
    for (int facet = 0; !isImage(facet); ++facet)
    {
        if (facetBody[facet] < 0)
        {
            fixed_.facets.push_back(facet);
        }
        else
        {
            moving_.facets.push_back(facet);
            movingBody.push_back(facetBody[facet]);
        }
    }
    fixed_.tree = BoxTree<D>(bounds(fixed_.facets), std::vector<int>(fixed_.facets.size(), 0));
    moving_.tree = BoxTree<D>(bounds(moving_.facets), movingBody);
}

template <int D>
void WallContact<D>::makeImages(std::vector<Facet<D>>& facets, std::vector<int>& bodies)
{
    if (!periodic_ || facets.empty())
    {
        return;
    }
    std::vector<Bounds<D>> boxes;
    Bounds<D> all = boundsOf<D>(facets[0]);
    for (const Facet<D>& facet : facets)
    {
        boxes.push_back(boundsOf<D>(facet));
        all.enclose(boxes.back());
    }
    const double near = 1e-9 * (all.upper - all.lower).maxCoeff();
    const BoxTree<D> tree(boxes, std::vector<int>(boxes.size(), 0));

    Vectors<D> shifts{Vector<D>::Zero()};
    for (int d = 0; d < D; ++d)
    {
        const int periods = period_[d] > 0 ? static_cast<int>((all.upper[d] - all.lower[d] + near) / period_[d]) : 0;
        const Vectors<D> before = shifts;
        for (int k = 1; k <= periods; ++k)
        {
            for (const Vector<D>& shift : before)
            {
                shifts.push_back(shift - k * period_[d] * Vector<D>::Unit(d));
                shifts.push_back(shift + k * period_[d] * Vector<D>::Unit(d));
            }
        }
    }
    for (int f = 0; f < static_cast<int>(boxes.size()); ++f)
    {
        for (std::size_t s = 1; s < shifts.size(); ++s)
        {
            const Vector<D>& shift = shifts[s];
            bool touches = false, coversItself = false;   // a facet that is longer than the period has no seam
            for (int d = 0; d < D; ++d)
            {
                const double length = boxes[f].upper[d] - boxes[f].lower[d];
                coversItself = coversItself || (shift[d] != 0 && length > period_[d] + near);
            }
            const Vector<D> margin = Vector<D>::Constant(near);
            tree.forMeeting({boxes[f].lower + shift - margin, boxes[f].upper + shift + margin},
                            [&](int other) { touches = touches || bodies[other] == bodies[f]; });
            if (touches && !coversItself)
            {
                images_.push_back({f, shift});
            }
        }
    }
    for (const Image& image : images_)
    {
        facets.push_back(facets[image.facet]);
        for (Vector<D>& corner : facets.back())
        {
            corner += image.shift;
        }
        bodies.push_back(bodies[image.facet]);
    }
}

template <int D>
bool WallContact<D>::isAstray(int facet) const
{
    const Image& image = imageOf(facet);
    const int body = body_[wallOf_[image.facet]];
    return body >= 0 && !motions_.empty() && (motions_[body].turn * image.shift).norm() > 1e-12 * image.shift.norm();
}

template <int D>
std::vector<Bounds<D>> WallContact<D>::bounds(const std::vector<int>& facets) const
{
    std::vector<Bounds<D>> boxes;
    for (const int facet : facets)
    {
        boxes.push_back(mesh_.bounds(facet));
        Bounds<D>& box = boxes.back();
        for (int d = 0; d < D; ++d)
        {
            if (period_[d] > 0)   // the image whose middle is in the box
            {
                const double shift = period_[d] * std::floor((box.lower[d] + box.upper[d]) / (2 * period_[d]));
                box.lower[d] -= shift;
                box.upper[d] -= shift;
            }
        }
    }
    return boxes;
}

template <int D>
Vector<D> WallContact<D>::image(int wall, const Vector<D>& x) const
{
    return periodic_ && facetOf_[wall] >= 0 ? imageNearFacet(facetOf_[wall], x) : x;
}

template <int D>
Vector<D> WallContact<D>::imageNearFacet(int facet, const Vector<D>& x) const
{
    const Bounds<D> box = mesh_.bounds(facet);
    Vector<D> nearest = x;
    for (int d = 0; d < D; ++d)
    {
        if (period_[d] > 0)
        {
            nearest[d] -= period_[d] * std::round((x[d] - (box.lower[d] + box.upper[d]) / 2) / period_[d]);
        }
    }
    // A facet at an angle to the axes may be nearer to the image next to that
    const auto squareOf = [&](const Vector<D>& y) { return (mesh_.nearest(facet, y).point - y).squaredNorm(); };
    double shortest = squareOf(nearest);
    for (int d = 0; d < D; ++d)
    {
        const Vector<D> middle = nearest;
        for (const double shift : {-period_[d], period_[d]})
        {
            const Vector<D> other = middle + shift * Vector<D>::Unit(d);
            const double square = shift != 0 ? squareOf(other) : shortest;
            if (square < shortest)
            {
                shortest = square;
                nearest = other;
            }
        }
    }
    return nearest;
}

template <int D>
double WallContact<D>::height(const HalfSpace& halfSpace, const Vector<D>& x) const
{
    return (x - halfSpace.point).dot(halfSpace.normal);
}

template <int D>
bool WallContact<D>::isBeyond(int wall, const Vector<D>& x, double reach) const
{
    const int facet = facetOf_[wall];
    if (facet < 0)
    {
        return height(halfSpaces_[~facet], x) > reach;
    }
    return !periodic_ && std::abs(mesh_.height(facet, x)) > reach;
}

template <int D>
double WallContact<D>::distance(int wall, const Vector<D>& x) const
{
    const int facet = facetOf_[wall];
    const Vector<D> near = image(wall, x);
    return facet < 0 ? height(halfSpaces_[~facet], x) : (mesh_.nearest(facet, near).point - near).norm();
}

template <int D>
Vector<D> WallContact<D>::way(int wall, const Vector<D>& x) const
{
    const int facet = facetOf_[wall];
    if (facet < 0)
    {
        return -height(halfSpaces_[~facet], x) * halfSpaces_[~facet].normal;
    }
    const Vector<D> near = image(wall, x);
    return mesh_.nearest(facet, near).point - near;
}

template <int D>
bool WallContact<D>::separates(const Vector<D>& x, const Vector<D>& way) const
{
    // What passes between two facets that share an edge passes one of them
    const double seam = 1e-9 * way.norm();
    const Vector<D> middle = x + way / 2;
    bool found = false;
    forNear(middle, way.norm() / 2,
            [&](int wall)
            {
                const int facet = facetOf_[wall];
                if (facet < 0 || found)
                {
                    return;
                }
                const Vector<D> from = image(wall, middle) - way / 2;
                const double before = mesh_.height(facet, from);
                const double behind = mesh_.height(facet, from + way);
                if (before * behind < 0)
                {
                    const Vector<D> crossing = from + before / (before - behind) * way;
                    found = (mesh_.nearest(facet, crossing).point - crossing).norm() <= seam;
                }
            });
    return found;
}

template <int D>
Approach<D> WallContact<D>::approachPlane(int facet, const Vector<D>& centre, double radius) const
{
    const double height = mesh_.height(facet, centre);
    return {height < 0 ? mesh_.normal(facet) : Vector<D>(-mesh_.normal(facet)), std::abs(height) - radius};
}

template <int D>
Approach<D> WallContact<D>::approachJoint(int facet, const Vector<D>& point, const Vector<D>& centre,
                                          double radius) const
{
    const Vector<D> toWall = point - centre;
    const double distance = toWall.norm();
    if (distance > mesh_.roundOff())
    {
        return {toWall / distance, distance - radius};
    }
    return {-mesh_.normal(facet), -radius};   // centre on the joint: push it to the side of the facet's normal
}

template <int D>
std::optional<Approach<D>> WallContact<D>::approach(int wall, const Vector<D>& centre, double radius) const
{
    const int facet = facetOf_[wall];
    if (facet < 0)
    {
        const HalfSpace& halfSpace = halfSpaces_[~facet];
        return Approach<D>{-halfSpace.normal, height(halfSpace, centre) - radius};
    }
    return approachFacet(facet, periodic_ ? imageNearFacet(facet, centre) : centre, radius);
}

template <int D>
std::optional<Approach<D>> WallContact<D>::approachFacet(int facet, const Vector<D>& centre, double radius) const
{
    const Foot<D> foot = mesh_.nearest(facet, centre);
    if (foot.joint < 0)
    {
        return approachPlane(facet, centre, radius);
    }

    const Company others = company(facet, foot.joint, centre, false);
    if (others.nearest < 0)
    {
        return others.first ? std::optional(approachJoint(facet, foot.point, centre, radius)) : std::nullopt;
    }
    const Approach<D> continued = approachPlane(facet, centre, radius);
    return others.hollow && continued.gap > 0 && inHollow(others.nearest, centre) ? std::optional(continued)
                                                                                 : std::nullopt;
}

template <int D>
auto WallContact<D>::company(int facet, int joint, const Vector<D>& x, bool flat) const -> Company
{
    Company company;
    double shortest = 0;
    const bool above = mesh_.height(facet, x) >= 0;
    const std::size_t own = mesh_.placeAt(joint, facet);
    std::size_t place = 0;
    for (const int other : mesh_.facetsAt(joint))
    {
        const std::size_t its = place++;
        const int itself = isImage(other) ? imageOf(other).facet : other;
        if (itself == facet || (isImage(other) && isAstray(other)))
        {
            continue;
        }
        const Foot<D> foot = mesh_.nearest(other, x);
        const bool nearer = foot.joint != joint;
        if (!nearer && facet < itself)
        {
            continue;
        }
        company.first = company.first && nearer;
        const Sides& otherOverThis = mesh_.sides(joint, its, own);
        const Sides& thisOverOther = mesh_.sides(joint, own, its);
        if (!flat && otherOverThis.none() && thisOverOther.none())
        {
            company.hollow = false;   // the plane is the other one's
        }
        if (!nearer)
        {
            continue;
        }
        const bool aboveOther = mesh_.height(other, x) >= 0;
        company.hollow = company.hollow && !otherOverThis.lies(!above) && !thisOverOther.lies(!aboveOther);
        const double square = (foot.point - x).squaredNorm();
        if (company.nearest < 0 || square < shortest)
        {
            company.nearest = other;
            shortest = square;
        }
        if (!company.hollow)
        {
            break;
        }
    }
    return company;
}

template <int D>
bool WallContact<D>::inHollow(int facet, Vector<D> x) const
{
    for (;;)
    {
        if (isImage(facet))
        {
            x -= imageOf(facet).shift;
            facet = imageOf(facet).facet;
        }
        const Foot<D> foot = mesh_.nearest(facet, x);
        if (foot.joint < 0)
        {
            return true;
        }
        const Company others = company(facet, foot.joint, x, true);
        if (others.nearest < 0)
        {
            const Vector<D> below = x - mesh_.height(facet, x) * mesh_.normal(facet);
            return (below - foot.point).norm() <= 4 * mesh_.roundOff();
        }
        if (!others.hollow)
        {
            return false;
        }
        facet = others.nearest;
    }
}

template <int D>
void WallContact<D>::place(const std::vector<WallBody<D>>& initial, const std::vector<WallBody<D>>& now)
{
    std::vector<RigidMotion<D>> motions = rigidMotions<D>(initial, now);
    if (motions == motions_)
    {
        return;
    }
    for (HalfSpace& halfSpace : halfSpaces_)
    {
        const int body = body_[halfSpace.wall];
        if (body < 0)
        {
            continue;
        }
        if (motions[body].turn.cwiseAbs().maxCoeff() > 1e-12)
        {
            refuse("wall ", halfSpace.wall, ": a plane cannot turn with its body ", body, "; make it of triangles");
        }
        halfSpace.point = halfSpace.initialPoint + motions[body].shift;
    }
    mesh_.move(motions);
    moving_.tree.refit(bounds(moving_.facets));
    motions_ = std::move(motions);
}

template class WallContact<2>;
template class WallContact<3>;

}  // namespace nscd
