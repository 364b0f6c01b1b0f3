// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/mesh/CellShape.hpp"

#include "overlap/disc/DiscPolygon.hpp"

#include <algorithm>

namespace overlap
{

namespace
{

/// f(facet, sign) for every facet of a cell.
template <class F>
void forFacets(const Facets& facets, const CellFace* faces, std::size_t nFaces, F&& f)
{
    for (std::size_t i = 0; i < nFaces; ++i)
    {
        for (const Facet* facet = facets.begin(faces[i].face); facet != facets.end(faces[i].face); ++facet)
        {
            f(*facet, faces[i].sign);
        }
    }
}

}  // namespace

CellShape cellShape(const Facets& facets, const CellFace* faces, std::size_t nFaces, const Point3* vertices,
                    std::size_t nVertices)
{
    CellShape shape{vertices[0], vertices[0], Point3::Zero(), 0, 0};
    for (std::size_t k = 0; k < nVertices; ++k)
    {
        shape.low = shape.low.cwiseMin(vertices[k]);
        shape.high = shape.high.cwiseMax(vertices[k]);
        shape.centroid += (vertices[k] - vertices[0]) / static_cast<double>(nVertices);
    }
    const Point3 middle = vertices[0] + shape.centroid;
    const double rounding = 1e-12 * (shape.high - shape.low).norm();

    // Cones from the middle to the facets: volume A h/3, centroid at 3/4 of the way to the facet's
    Point3 moment = Point3::Zero();
    const auto addCone = [&](const Facet& facet, double sign)
    {
        const AreaMoment plane = polygon(facets.vertices(facet), facets.nVertices(facet));
        const Point3 origin = facet.origin - middle;
        const Point3 centroid =
            origin + plane.centroid.x() * facet.tangent + plane.centroid.y() * facet.normal.cross(facet.tangent);
        const double cone = sign * facet.normal.dot(origin) * plane.area / 3;
        shape.volume += cone;
        moment += 0.75 * cone * centroid;
        for (std::size_t k = 0; k < nVertices; ++k)
        {
            shape.dent = std::max(shape.dent, sign * facet.normal.dot(vertices[k] - facet.origin));
        }
    };
    forFacets(facets, faces, nFaces, addCone);
    shape.dent = shape.dent > rounding ? shape.dent + rounding : 0;

    shape.centroid = middle;
    if (shape.volume > 0) shape.centroid += moment / shape.volume;
    shape.centroid = shape.centroid.cwiseMax(shape.low).cwiseMin(shape.high);
    return shape;
}

double gap(const Facets& facets, const CellFace* faces, std::size_t nFaces)
{
    Point3 sum = Point3::Zero();
    double areas = 0;
    const auto add = [&](const Facet& facet, double sign)
    {
        const double area = facets.area(facet);
        sum += sign * area * facet.normal;
        areas += std::abs(area);
    };
    forFacets(facets, faces, nFaces, add);
    return areas > 0 ? sum.norm() / areas : 1;
}

}  // namespace overlap
