/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutBody.H"

#include "inMesh.H"
#include "overlap/clip/Clip.hpp"
#include "overlap/disc/DiscEdge.hpp"
#include "overlap/disc/DiscPolygon.hpp"

namespace
{

using namespace Foam;

//- Beyond a boundary between power cells that is at the same distance everywhere
template<class Boundary>
bool isBeyond(const Boundary& x, const scalar distance)
{
    return distance > 0 || (distance == 0 && !x.isFirst);
}


//- Leave what is within a power cell of an edge
template<class Boundaries>
void leaveWithin
(
    const Boundaries& cell,
    overlap::Point2& a,
    overlap::Point2& b
)
{
    for (const auto& x : cell)
    {
        const scalar atA = x.half.distance(a);
        const scalar atB = x.half.distance(b);
        if (atA == atB ? isBeyond(x, atA) : min(atA, atB) >= 0)
        {
            b = a;
            return;
        }
        if (max(atA, atB) > 0)
        {
            const overlap::Point2 between(a + atA/(atA - atB)*(b - a));
            (atA > 0 ? a : b) = between;
        }
    }
}


//- Leave what is within a power cell of a polygon, in axes e1 and e2 about its middle
template<class Boundaries>
void leaveWithin
(
    const Boundaries& cell,
    const overlap::Point3& middle,
    const overlap::Point3& e1,
    const overlap::Point3& e2,
    std::vector<overlap::Point2>& polygon
)
{
    // Sine of the angle to a face from which on a boundary is not parallel to it
    constexpr scalar least = 1e-12;

    for (const auto& x : cell)
    {
        const overlap::Point2 normal(x.half.normal.dot(e1), x.half.normal.dot(e2));
        const scalar sine = normal.norm();
        const scalar distance = x.half.distance(middle);
        if (sine > least)
        {
            const overlap::Point2 n(normal/sine);
            polygon = overlap::clipped(polygon, {n, -distance/sine*n});
        }
        else if (isBeyond(x, distance))
        {
            polygon.clear();
        }
    }
}


overlap::Point3 toEigen(const vector& x)
{
    return overlap::Point3(x.x(), x.y(), x.z());
}

}


overlap::Point2 Foam::cutBody::toPlane(const vector& x) const
{
    overlap::Point2 result;
    int k = 0;
    for (direction i = 0; i < vector::nComponents; ++i)
    {
        if (mesh_.geometricD()[i] > 0)
        {
            result[k++] = x[i];
        }
    }
    return result;
}


Foam::vector Foam::cutBody::fromPlane(const overlap::Point2& x) const
{
    vector result(Zero);
    int k = 0;
    for (direction i = 0; i < vector::nComponents; ++i)
    {
        if (mesh_.geometricD()[i] > 0)
        {
            result[i] = x[k++];
        }
    }
    return result;
}


template<int D, class ToPoint>
void Foam::cutBody::setPowerCells
(
    const ToPoint& toPoint,
    DynamicList<boundary<D>> member::* cuts
)
{
    for (label i = 0; i < members_.size(); ++i)
    {
        for (label j = i + 1; j < members_.size(); ++j)
        {
            const std::vector<overlap::Sphere<D>> pair
            {
                {toPoint(members_[i].arm), members_[i].radius},
                {toPoint(members_[j].arm), members_[j].radius}
            };
            const auto first = overlap::powerCell(pair, 0);
            const auto second = overlap::powerCell(pair, 1);
            if (!first || !second)
            {
                members_[first ? j : i].isHidden = true;
                continue;
            }
            if (first->empty() && second->empty())
            {
                continue;
            }
            const overlap::HalfSpace<D> own
            (
                first->empty()
              ? overlap::HalfSpace<D>{-(*second)[0].normal, (*second)[0].point}
              : (*first)[0]
            );
            (members_[i].*cuts).append(boundary<D>{own, true});
            (members_[j].*cuts).append
            (
                boundary<D>{{-own.normal, own.point}, false}
            );
        }
    }
}


Foam::cutBody::cutBody
(
    const fvMesh& mesh,
    const point& centre,
    const UList<grainMember>& members
)
:
    mesh_(mesh),
    members_(members.size())
{
    forAll(members, i)
    {
        members_[i].arm = inMesh(mesh, members[i].centre - centre);
        members_[i].radius = members[i].radius;
        members_[i].isHidden = false;
    }
    if (isRound())
    {
        return;
    }

    if (mesh.nGeometricD() == 3)
    {
        setPowerCells<3>(toEigen, &member::spatial);
    }
    else
    {
        setPowerCells<2>
        (
            [this](const vector& x) { return toPlane(x); }, &member::planar
        );
    }
}


Foam::cutBody::part Foam::cutBody::planarPart
(
    const label facei,
    const vector& toMiddle
) const
{
    const point& middle = mesh_.faceCentres()[facei];

    // Of a mesh one cell thick, the edge in its plane
    vector first(Zero), last(Zero);
    scalar longest = -1;
    for (const label pointi : mesh_.faces()[facei])
    {
        const vector x(inMesh(mesh_, mesh_.points()[pointi] - middle));
        if (longest < 0)
        {
            first = x;
            longest = 0;
        }
        if (mag(x - first) > longest)
        {
            last = x;
            longest = mag(x - first);
        }
    }

    const overlap::Point2 p(toPlane(toMiddle + first));
    const overlap::Point2 q(toPlane(toMiddle + last));
    const scalar length = (q - p).norm();
    part result{0, Zero};
    for (const member& x : members_)
    {
        overlap::Point2 a(p), b(q);
        leaveWithin(x.planar, a, b);
        if (x.isHidden || a == b)
        {
            continue;
        }
        const overlap::EdgePart within
        (
            overlap::edgeInDisc(toPlane(x.arm), x.radius, a, b)
        );
        result.share += within.length/length;
        result.arm += within.length/length*fromPlane(within.middle);
    }
    result.arm /= max(result.share, VSMALL);
    return result;
}


Foam::cutBody::part Foam::cutBody::spatialPart
(
    const label facei,
    const vector& toMiddle
) const
{
    const vector& S = mesh_.faceAreas()[facei];
    const vector n(S/mag(S));
    const point& middle = mesh_.faceCentres()[facei];
    const face& corners = mesh_.faces()[facei];

    // The circle that the face's plane cuts out of a sphere, seen along the normal
    const vector along(mesh_.points()[corners[0]] - middle);
    const vector e1(normalised(along - (along & n)*n));
    const vector e2(n ^ e1);
    std::vector<overlap::Point2> whole;
    part result{0, Zero};
    for (const member& x : members_)
    {
        const vector toFace(toMiddle - x.arm);
        const scalar height = toFace & n;
        const scalar squaredRadius = sqr(x.radius) - sqr(height);
        if (squaredRadius <= 0 || x.isHidden)
        {
            continue;
        }
        if (whole.empty())
        {
            for (const label pointi : corners)
            {
                const vector corner(mesh_.points()[pointi] - middle);
                whole.emplace_back(corner & e1, corner & e2);
            }
        }
        std::vector<overlap::Point2> polygon(whole);
        leaveWithin(x.spatial, toEigen(toMiddle), toEigen(e1), toEigen(e2), polygon);
        if (polygon.size() < 3)
        {
            continue;
        }
        const overlap::AreaMoment within = overlap::discPolygon
        (
            overlap::Point2(-(toFace & e1), -(toFace & e2)),
            Foam::sqrt(squaredRadius),
            polygon.data(),
            polygon.size()
        );
        const scalar share = within.area/mag(S);
        result.share += share;
        result.arm +=
            share*(toMiddle + within.centroid[0]*e1 + within.centroid[1]*e2);
    }
    result.arm /= max(result.share, VSMALL);
    result.share = min(result.share, scalar(1));
    return result;
}


Foam::cutBody::part Foam::cutBody::of
(
    const label facei,
    const vector& toMiddle
) const
{
    return
        mesh_.nGeometricD() == 3
      ? spatialPart(facei, toMiddle)
      : planarPart(facei, toMiddle);
}


Foam::cutBody::surfacePoint Foam::cutBody::nearest(const vector& toPoint) const
{
    surfacePoint result{Zero, Zero, 0, GREAT};
    for (const member& x : members_)
    {
        const vector r(toPoint - x.arm);
        const scalar distance = mag(r) - x.radius;
        if (distance < result.distance)
        {
            const vector arm(x.radius*r/max(mag(r), VSMALL));
            result = {x.arm + arm, arm/max(mag(arm), VSMALL), x.radius, distance};
        }
    }
    return result;
}
