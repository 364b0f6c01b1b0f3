// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "overlap/clip/Clip.hpp"

#include <algorithm>

namespace overlap
{

namespace
{

template <class Point>
struct ClippedLoop
{
    std::vector<Point> vertices;
    std::vector<std::pair<Point, Point>> closing;  ///< edges on the boundary of the half-space
};

/// The same for p -> q and q -> p, bit for bit, so that faces keep their common edges.
template <class Point>
Point crossing(const Point& p, double dp, const Point& q, double dq)
{
    if (std::lexicographical_compare(q.data(), q.data() + q.size(), p.data(), p.data() + p.size()))
    {
        return crossing(q, dq, p, dp);
    }
    return p + dp / (dp - dq) * (q - p);
}

template <int D, class Point = Eigen::Matrix<double, D, 1>>
ClippedLoop<Point> clippedLoop(const Point* loop, std::size_t n, const HalfSpace<D>& half)
{
    ClippedLoop<Point> result;
    std::vector<Point> exits, entries;
    bool beginsWithEntry = false;
    double dp = half.distance(loop[n - 1]);
    for (std::size_t k = 0; k < n; ++k)
    {
        const Point& p = loop[k == 0 ? n - 1 : k - 1];
        const Point& q = loop[k];
        const double dq = half.distance(q);
        if ((dp <= 0) != (dq <= 0))
        {
            const Point x = crossing(p, dp, q, dq);
            beginsWithEntry = beginsWithEntry || (dq <= 0 && exits.empty());
            (dq <= 0 ? entries : exits).push_back(x);
            result.vertices.push_back(x);
        }
        if (dq <= 0) result.vertices.push_back(q);
        dp = dq;
    }

    // Each exit is followed by an entry, the last one by the first if that came before any exit
    for (std::size_t k = 0; k < exits.size(); ++k)
    {
        result.closing.emplace_back(exits[k], entries[(k + beginsWithEntry) % entries.size()]);
    }
    return result;
}

}  // namespace

std::vector<Point2> clipped(const std::vector<Point2>& polygon, const HalfSpace<2>& half)
{
    if (polygon.empty()) return polygon;
    return clippedLoop<2>(polygon.data(), polygon.size(), half).vertices;
}

Polyhedron clipped(const Polyhedron& cell, const HalfSpace<3>& half)
{
    Facets facets;
    std::vector<Point3> loops, cap;
    cell.forLoops(
        [&](const Facet& facet, const Point3* loop, std::size_t n)
        {
            const ClippedLoop<Point3> part = clippedLoop<3>(loop, n, half);
            if (part.vertices.size() >= 3)
            {
                facets.addLoop(facet, part.vertices.data(), part.vertices.size());
                loops.insert(loops.end(), part.vertices.begin(), part.vertices.end());
            }

            // The cap has the closing edges the other way round.  Their order does not matter: triangles from one of
            // their ends have all other edges in pairs that cancel.
            for (const auto& [exit, entry] : part.closing)
            {
                const Point3 hub = cap.empty() ? entry : cap[0];
                cap.insert(cap.end(), {hub, entry, exit});
            }
        });
    if (!cap.empty())
    {
        facets.addLoop(half.normal, half.point, cap.data(), cap.size());
        loops.insert(loops.end(), cap.begin(), cap.end());
    }
    return Polyhedron(std::move(facets), std::move(loops));
}

}  // namespace overlap
