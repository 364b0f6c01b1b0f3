// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/ball/BallFace.hpp"

#include "overlap/ball/InnerIntegrals.hpp"
#include "overlap/ball/OuterIntegrals.hpp"
#include "overlap/ball/SliverIntegrals.hpp"

#include <stdexcept>

namespace overlap
{

namespace
{

/// Whether the facet is closer to the foot than nearFace.
bool isNear(const BallFacet& local, const Facets& facets, const Facet& facet)
{
    const Point2* v = facets.vertices(facet);
    const std::size_t n = facets.nVertices(facet);
    AngleSum angles;
    for (std::size_t k = 0; k < n; ++k)
    {
        const Point2 p = (v[k] - local.foot) * local.scale, q = (v[k + 1 == n ? 0 : k + 1] - local.foot) * local.scale;
        const Point2 d = q - p;
        const double d2 = d.squaredNorm(), t = d2 > 0 ? std::clamp(-p.dot(d) / d2, 0.0, 1.0) : 0;
        if ((p + t * d).squaredNorm() < nearFace * nearFace) return true;
        angles.add(p.dot(q), cross(p, d));
    }
    return angles.turns() != 0;
}

template <class F>
void forReachedFacets(const UnitBall& ball, const Facets& facets, std::size_t face, F&& f)
{
    for (const Facet* facet = facets.begin(face); facet != facets.end(face); ++facet)
    {
        if (std::abs(height(ball, *facet)) >= 1) continue;
        const BallFacet local(ball, *facet);
        if (local.meets(std::sqrt(local.a2))) f(local, *facet);
    }
}

template <class Integrals>
void addTo(FaceParts& parts, const BallFacet& local, const Facets& facets, const Facet& facet)
{
    Integrals integrals(local.h);
    local.forEdges(facets.vertices(facet), facets.nVertices(facet), integrals);
    integrals.addTo(parts, local.sign(), facet.normal);
}

}  // namespace

UnitBall unitBall(const Point3& centre, double radius)
{
    if (!isFinite(centre)) throw std::invalid_argument("overlap: the ball's centre is not finite");
    if (!(std::isfinite(radius) && radius > 0))
        throw std::invalid_argument("overlap: the ball's radius is not positive");
    return {centre, radius, 1 / radius};
}

FaceParts innerParts(const UnitBall& ball, const Facets& facets, std::size_t face)
{
    FaceParts parts;
    parts.resolved = true;
    const auto add = [&](const BallFacet& local, const Facet& facet)
    {
        const bool isSmall = (local.high - local.low).squaredNorm() < smallFace * smallFace;
        const bool mayBeNear = local.h < nearFace && local.meets(nearFace);
        parts.near = parts.near || (mayBeNear && isNear(local, facets, facet));
        parts.resolved = parts.resolved && isSmall;
        if (isSmall)
        {
            addTo<SliverIntegrals>(parts, local, facets, facet);
        }
        else
        {
            addTo<InnerIntegrals>(parts, local, facets, facet);
        }
    };
    forReachedFacets(ball, facets, face, add);
    return parts;
}

FaceParts resolvedParts(const UnitBall& ball, const Facets& facets, std::size_t face)
{
    FaceParts parts;
    parts.resolved = true;
    forReachedFacets(ball, facets, face,
                     [&](const BallFacet& local, const Facet& facet)
                     { addTo<SliverIntegrals>(parts, local, facets, facet); });
    return parts;
}

OuterParts outerParts(const UnitBall& ball, const Facets& facets, std::size_t face)
{
    OuterParts parts;
    for (const Facet* facet = facets.begin(face); facet != facets.end(face); ++facet)
    {
        const BallFacet local(ball, *facet);
        OuterIntegrals integrals(local.h);
        local.forEdges(facets.vertices(*facet), facets.nVertices(*facet), integrals);
        integrals.addTo(parts, local.sign());
    }
    return parts;
}

double solidAngle(const UnitBall& ball, const Facets& facets, std::size_t face)
{
    double sum = 0;
    for (const Facet* facet = facets.begin(face); facet != facets.end(face); ++facet)
    {
        const BallFacet local(ball, *facet);
        const double h2 = local.h * local.h;
        const Point2* v = facets.vertices(*facet);
        const std::size_t n = facets.nVertices(*facet);
        AngleSum half;
        for (std::size_t k = 0; k < n; ++k)
        {
            const Point2 p = (v[k] - local.foot) * ball.scale,
                         q = (v[k + 1 == n ? 0 : k + 1] - local.foot) * ball.scale;
            const double rp = std::sqrt(h2 + p.squaredNorm()), rq = std::sqrt(h2 + q.squaredNorm());
            addHalfSolidAngle(half, local.h, p, rp, q, rq, cross(p, q - p));
        }
        sum += local.sign() * 2 * half.value();
    }
    return sum;
}

}  // namespace overlap
