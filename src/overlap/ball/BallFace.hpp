// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/mesh/Facets.hpp"

#include <algorithm>
#include <utility>

namespace overlap
{

/// Lengths, areas and volumes below are in units of the radius, from the ball's centre.
struct UnitBall
{
    Point3 centre;
    double radius;  ///< [m]
    double scale;   ///< 1/radius [1/m]
};

/// Throws std::invalid_argument if the radius is not positive or a number is not finite.
UnitBall unitBall(const Point3& centre, double radius);

/// Distance of the facet's plane from the centre, positive if the centre is behind the facet.
inline double height(const UnitBall& ball, const Facet& facet)
{
    return facet.normal.dot(facet.origin - ball.centre) * ball.scale;
}

/// Lowest and highest height of a face's planes.
inline std::pair<double, double> heightRange(const UnitBall& ball, const Facets& facets, std::size_t face)
{
    const Facet* facet = facets.begin(face);
    const Facet* end = facets.end(face);
    if (facet == end) return {1e300, -1e300};  // no plane: out of reach from either side
    const double first = height(ball, *facet);
    std::pair<double, double> range(first, first);
    while (++facet != end)
    {
        const double h = height(ball, *facet);
        range = {std::min(range.first, h), std::max(range.second, h)};
    }
    return range;
}

/// What a face contributes to the overlap of the ball with the cell that the face bounds; with opposite sign for the
/// cell on its other side.  Sums over the facets, s the sign of the height:
struct FaceParts
{
    bool reached = false;   ///< the ball's surface or inside meets the face
    bool near = false;      ///< the centre is closer to the face than nearFace
    bool resolved = false;  ///< without cancellation
    double volume = 0;      ///< of s K, K the volume between facet and sphere as seen from the centre
    double patch = 0;       ///< of s O, O the solid angle of the part of the facet within the ball
    double area = 0;        ///< of the part within the ball
    Point3 areaVector = Point3::Zero();
    Point3 moment = Point3::Zero();  ///< -1/2 n J, J the integral of 1 - |x|^2 over the part within the ball
};

/// Volume and area of the sphere's surface that a face cuts out, as seen from the centre.
struct OuterParts
{
    double volume = 0;
    double patch = 0;
};

/// Where the centre is closer than this to a face that bounds the cell, solid angles of what is within the ball are
/// noise, those of what is outside are not.
constexpr double nearFace = 0.02;

/// Faces that are smaller than this take quadrature at once.
constexpr double smallFace = 0.2;

/// In closed form, or by quadrature where the face is small.
FaceParts innerParts(const UnitBall& ball, const Facets& facets, std::size_t face);

/// By quadrature, without cancellation, to 1e-14: for overlaps much smaller than the ball.
FaceParts resolvedParts(const UnitBall& ball, const Facets& facets, std::size_t face);

/// From what is outside the ball; faces out of reach count as well.
OuterParts outerParts(const UnitBall& ball, const Facets& facets, std::size_t face);

/// Solid angle of a face, negative if the centre is in front of it.
double solidAngle(const UnitBall& ball, const Facets& facets, std::size_t face);

}  // namespace overlap
