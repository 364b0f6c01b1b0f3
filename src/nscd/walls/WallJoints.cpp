// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/walls/WallJoints.hpp"

#include "nscd/search/BoxTree.hpp"
#include "nscd/search/CellGrid.hpp"

#include <numeric>

namespace nscd
{

namespace
{

template <int D>
Bounds<D> around(const Vector<D>& a, const Vector<D>& b, double margin)
{
    const Vector<D> reach = Vector<D>::Constant(margin);
    return {a.cwiseMin(b) - reach, a.cwiseMax(b) + reach};
}

template <int D>
double largestExtent(const Vectors<D>& points)
{
    Bounds<D> all{points[0], points[0]};
    for (const Vector<D>& x : points)
    {
        all.enclose({x, x});
    }
    return (all.upper - all.lower).maxCoeff();
}

/// Numbers that are the same for points of the same body not further apart than 'same'; the first point of every
/// number.
template <int D>
std::pair<std::vector<int>, std::vector<int>> weld(const Vectors<D>& points, const std::vector<int>& body, double same)
{
    const CellGrid<D> grid(points, 2 * same);
    std::vector<int> number(points.size(), -1);
    std::vector<int> first;
    for (std::size_t p = 0; p < points.size(); ++p)
    {
        if (number[p] >= 0)
        {
            continue;
        }
        const Bounds<D> near = around(points[p], points[p], same);
        grid.forCells(grid.coordinates(near.lower), grid.coordinates(near.upper),
                      [&](std::size_t cell)
                      {
                          for (int m = grid.begin()[cell]; m < grid.begin()[cell + 1]; ++m)
                          {
                              const int q = grid.members()[m];
                              if (number[q] < 0 && body[q] == body[p] && (points[q] - points[p]).norm() <= same)
                              {
                                  number[q] = static_cast<int>(first.size());
                              }
                          }
                      });
        first.push_back(static_cast<int>(p));
    }
    return {number, first};
}

std::array<int, 2> ordered(int a, int b)
{
    return a < b ? std::array<int, 2>{a, b} : std::array<int, 2>{b, a};
}

/// Finds the corners of free edges that lie on another free edge.
class EdgeCutter
{
public:
    EdgeCutter(const WallJoints<3>& joints, const std::vector<std::array<int, 2>>& freeEdges, double same)
        : joints_(joints), same_(same)
    {
        for (const auto& [a, b] : freeEdges)
        {
            corners_.insert(corners_.end(), {a, b});
        }
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
        std::vector<Bounds<3>> points;
        for (const int c : corners_)
        {
            points.push_back({joints.corner[c], joints.corner[c]});
        }
        tree_ = BoxTree<3>(points, std::vector<int>(points.size(), 0));
    }

    /// Corners on the edge from a to b, in this order, a included and b not.
    std::vector<int> cut(int a, int b) const
    {
        const Vector<3>& from = joints_.corner[a];
        const Vector<3> edge = joints_.corner[b] - from;
        const double length = edge.norm();
        std::vector<std::pair<double, int>> found{{0, a}};
        tree_.forMeeting(around<3>(from, joints_.corner[b], same_),
                         [&](int i)
                         {
                             const int c = corners_[i];
                             const Vector<3> x = joints_.corner[c] - from;
                             const double along = x.dot(edge) / length;
                             if (joints_.body[c] == joints_.body[a] && along > same_ && along < length - same_ &&
                                 x.cross(edge).norm() <= same_ * length)
                             {
                                 found.emplace_back(along, c);
                             }
                         });
        std::sort(found.begin(), found.end());
        std::vector<int> corners;
        std::transform(found.begin(), found.end(), std::back_inserter(corners), [](const auto& f) { return f.second; });
        return corners;
    }

private:
    const WallJoints<3>& joints_;
    double same_;
    std::vector<int> corners_;
    BoxTree<3> tree_;
};

}  // namespace

template <int D>
WallJoints<D>::WallJoints(const std::vector<Facet<D>>& facets, const std::vector<int>& bodies)
{
    if (facets.empty())
    {
        return;
    }
    Vectors<D> points;
    std::vector<int> bodyOfPoint;
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
        points.insert(points.end(), facets[f].begin(), facets[f].end());
        bodyOfPoint.insert(bodyOfPoint.end(), D, bodies[f]);
    }
    const double same = 1e-9 * largestExtent<D>(points);
    const auto [number, first] = weld<D>(points, bodyOfPoint, same);
    for (const int p : first)
    {
        corner.push_back(points[p]);
        body.push_back(bodyOfPoint[p]);
    }
    std::vector<std::array<int, D>> corners(facets.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
        corners[p / D][p % D] = number[p];
    }
    cutSides(corners, same);
    collectFacets();
}

template <>
void WallJoints<2>::cutSides(const std::vector<std::array<int, 2>>& corners, double)
{
    for (const auto& [a, b] : corners)
    {
        sideBegin.push_back(side.size());
        side.push_back({a, -1});
        side.push_back({b, -1});
    }
    sideBegin.push_back(side.size());
}

template <>
void WallJoints<3>::cutSides(const std::vector<std::array<int, 3>>& corners, double same)
{
    for (const auto& c : corners)
    {
        edge.insert(edge.end(), {ordered(c[0], c[1]), ordered(c[1], c[2]), ordered(c[2], c[0])});
    }
    std::sort(edge.begin(), edge.end());
    std::vector<std::array<int, 2>> freeEdges;
    for (std::size_t e = 0; e < edge.size(); ++e)
    {
        if ((e == 0 || edge[e - 1] != edge[e]) && (e + 1 == edge.size() || edge[e + 1] != edge[e]))
        {
            freeEdges.push_back(edge[e]);
        }
    }
    const EdgeCutter cutter(*this, freeEdges, same);

    std::vector<std::array<int, 2>> parts;
    for (const auto& c : corners)
    {
        sideBegin.push_back(parts.size());
        for (int k = 0; k < 3; ++k)
        {
            const int a = c[k];
            const int b = c[(k + 1) % 3];
            const bool isFree = std::binary_search(freeEdges.begin(), freeEdges.end(), ordered(a, b));
            std::vector<int> chain = isFree ? cutter.cut(a, b) : std::vector<int>{a};
            chain.push_back(b);
            for (std::size_t part = 0; part + 1 < chain.size(); ++part)
            {
                parts.push_back({chain[part], chain[part + 1]});
            }
        }
    }
    sideBegin.push_back(parts.size());

    edge.clear();
    for (const auto& [a, b] : parts)
    {
        edge.push_back(ordered(a, b));
    }
    std::sort(edge.begin(), edge.end());
    edge.erase(std::unique(edge.begin(), edge.end()), edge.end());
    for (const auto& [a, b] : parts)
    {
        const auto found = std::lower_bound(edge.begin(), edge.end(), ordered(a, b));
        side.push_back({a, static_cast<int>(found - edge.begin())});
    }
}

template <int D>
void WallJoints<D>::collectFacets()
{
    const auto forJoints = [this](auto&& f)
    {
        for (std::size_t n = 0; n + 1 < sideBegin.size(); ++n)
        {
            for (std::size_t s = sideBegin[n]; s < sideBegin[n + 1]; ++s)
            {
                f(side[s].corner, static_cast<int>(n));
                if (side[s].edge >= 0)
                {
                    f(jointOf(side[s].edge), static_cast<int>(n));
                }
            }
        }
    };
    facetBegin.assign(corner.size() + edge.size() + 1, 0);
    forJoints([this](int joint, int) { ++facetBegin[joint + 1]; });
    std::partial_sum(facetBegin.begin(), facetBegin.end(), facetBegin.begin());
    facet.resize(facetBegin.back());
    std::vector<std::size_t> next(facetBegin.begin(), facetBegin.end() - 1);
    forJoints([&](int joint, int number) { facet[next[joint]++] = number; });
}

template struct WallJoints<2>;
template struct WallJoints<3>;

}  // namespace nscd
