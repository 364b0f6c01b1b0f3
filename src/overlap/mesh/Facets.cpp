// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/mesh/Facets.hpp"

#include "overlap/disc/DiscPolygon.hpp"

#include <algorithm>
#include <limits>

namespace overlap
{

namespace
{

/// Twice the area vector of a triangle, by the cross product of its shorter edges: the one with the smallest rounding.
Point3 twiceAreaVector(const Point3& a, const Point3& b, const Point3& c)
{
    const Point3 ab = b - a, bc = c - b, ca = a - c;
    const double lengths[] = {ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()};
    switch (std::max_element(lengths, lengths + 3) - lengths)
    {
    case 0:
        return bc.cross(ca);
    case 1:
        return ca.cross(ab);
    default:
        return ab.cross(bc);
    }
}

/// Twice the area vector of a polygon.
Point3 twiceAreaVector(const Point3* v, std::size_t n)
{
    Point3 sum = Point3::Zero();
    for (std::size_t k = 1; k + 1 < n; ++k) sum += twiceAreaVector(v[0], v[k], v[k + 1]);
    return sum;
}

/// Tangents are exact where the normal is along an axis.
Facet frameOf(const Point3& normal, const Point3& origin)
{
    Facet frame;
    frame.origin = origin;
    frame.normal = normal;
    int axis;
    normal.cwiseAbs().minCoeff(&axis);
    frame.tangent = (Point3::Unit(axis) - normal[axis] * normal).normalized();
    return frame;
}

/// In a plane to within the rounding of the coordinates.
bool isPlane(const Point3& normal, const Point3* v, std::size_t n)
{
    double distance = 0, coordinate = 0;
    for (std::size_t k = 0; k < n; ++k)
    {
        distance = std::max(distance, std::abs(normal.dot(v[k] - v[0])));
        coordinate = std::max(coordinate, v[k].cwiseAbs().maxCoeff());
    }
    return distance <= 8 * std::numeric_limits<double>::epsilon() * coordinate;
}

}  // namespace

void Facets::clear()
{
    facets_.clear();
    vertices_.clear();
    faceStart_.assign(1, 0);
}

void Facets::addFace(const Point3* v, std::size_t n, std::vector<Point3>* loops)
{
    const auto add = [&](const Point3& areaVector, const Point3* loop, std::size_t size)
    {
        if (!(areaVector.squaredNorm() > 0)) return;
        addFacet(frameOf(areaVector.normalized(), loop[0]), loop, size);
        if (loops) loops->insert(loops->end(), loop, loop + size);
    };

    const Point3 whole = twiceAreaVector(v, n);
    if (n == 3 || (whole.squaredNorm() > 0 && isPlane(whole.normalized(), v, n)))
    {
        add(whole, v, n);
    }
    else
    {
        Point3 average = Point3::Zero();
        for (std::size_t k = 0; k < n; ++k) average += v[k];
        average /= static_cast<double>(n);
        for (std::size_t k = 0; k < n; ++k)
        {
            const Point3 triangle[] = {v[k], v[k + 1 == n ? 0 : k + 1], average};
            add(twiceAreaVector(triangle, 3), triangle, 3);
        }
    }
    faceStart_.push_back(static_cast<std::uint32_t>(facets_.size()));
}

void Facets::addLoop(const Facet& frame, const Point3* vertices, std::size_t n)
{
    addFacet(frame, vertices, n);
    faceStart_.push_back(static_cast<std::uint32_t>(facets_.size()));
}

void Facets::addLoop(const Point3& normal, const Point3& point, const Point3* vertices, std::size_t n)
{
    addLoop(frameOf(normal, point), vertices, n);
}

void Facets::addFacet(const Facet& frame, const Point3* vertices, std::size_t n)
{
    Facet facet = frame;
    facet.begin = static_cast<std::uint32_t>(vertices_.size());
    for (std::size_t k = 0; k < n; ++k)
    {
        const Point2 q = facet.inFrame(vertices[k]);
        facet.low = k == 0 ? q : Point2(facet.low.cwiseMin(q));
        facet.high = k == 0 ? q : Point2(facet.high.cwiseMax(q));
        vertices_.push_back(q);
    }
    facet.end = static_cast<std::uint32_t>(vertices_.size());
    facets_.push_back(facet);
}

double Facets::area(const Facet& facet) const
{
    return polygon(vertices(facet), nVertices(facet)).area;
}

double Facets::faceArea(std::size_t face) const
{
    double sum = 0;
    for (const Facet* facet = begin(face); facet != end(face); ++facet) sum += area(*facet);
    return sum;
}

}  // namespace overlap
