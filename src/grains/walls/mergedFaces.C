/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPieces.H"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace
{

typedef nscd::Vector<3> Point;
typedef std::vector<int> Polygon;           // indices of points
typedef std::pair<int, int> Edge;

// Vertices of a mesh are written with a finite number of digits
constexpr double parallel = 1e-9;

struct Less
{
    bool operator()(const Point& p, const Point& q) const
    {
        return std::lexicographical_compare
        (
            p.data(), p.data() + 3, q.data(), q.data() + 3
        );
    }
};


// Faces with numbered points, beginning with the smallest, in an order that
// does not depend on that of the list
struct Mesh
{
    std::vector<Point> points;
    std::vector<Polygon> faces;
    std::vector<Point> normals;             // of unit length
    std::vector<std::pair<int, int>> kind;  // material, body
    double flat = 0;                        // no face is so low [m]

    explicit Mesh(const Foam::wallPieceList<3>& list)
    {
        std::map<Point, int, Less> number;
        for (const Foam::wallFace& f : list)
        {
            for (const Point& p : f.vertices)
            {
                number[p] = 0;
            }
        }
        for (auto& entry : number)
        {
            entry.second = int(points.size());
            points.push_back(entry.first);
        }
        if (!points.empty())
        {
            Point lower(points[0]), upper(points[0]);
            for (const Point& p : points)
            {
                lower = lower.cwiseMin(p);
                upper = upper.cwiseMax(p);
            }
            flat = parallel*(upper - lower).maxCoeff();
        }

        std::vector<std::pair<Polygon, std::pair<int, int>>> sorted;
        for (const Foam::wallFace& f : list)
        {
            Polygon polygon;
            for (const Point& p : f.vertices)
            {
                polygon.push_back(number[p]);
            }
            std::rotate
            (
                polygon.begin(),
                std::min_element(polygon.begin(), polygon.end()),
                polygon.end()
            );
            sorted.push_back({polygon, {f.material, f.body}});
        }
        std::sort(sorted.begin(), sorted.end());
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());

        for (const auto& f : sorted)
        {
            faces.push_back(f.first);
            normals.push_back(area(f.first).normalized());
            kind.push_back(f.second);
        }
    }

    // Area vector of a polygon
    Point area(const Polygon& f) const
    {
        Point sum(Point::Zero());
        for (std::size_t i = 1; i + 1 < f.size(); ++i)
        {
            sum +=
                (points[f[i]] - points[f[0]]).cross
                (
                    points[f[i + 1]] - points[f[0]]
                )/2;
        }
        return sum;
    }

    Point average(const Polygon& f) const
    {
        Point sum(Point::Zero());
        for (const int i : f)
        {
            sum += points[i];
        }
        return sum/double(f.size());
    }

    double longestEdge(const Polygon& f) const
    {
        double longest = 0;
        for (std::size_t i = 0; i < f.size(); ++i)
        {
            const Point u(points[f[(i + 1)%f.size()]] - points[f[i]]);
            longest = std::max(longest, u.norm());
        }
        return longest;
    }

    // Is a polygon no more than an edge to nscd, which joins what is on its
    // two sides?
    bool isFlat(const Polygon& f) const
    {
        return 2*area(f).norm() <= flat*longestEdge(f);
    }

    // Do three points lie on a straight line?
    bool areStraight(const int a, const int b, const int c) const
    {
        const Point u(points[b] - points[a]);
        const Point v(points[c] - points[b]);
        return u.cross(v).norm() <= parallel*u.norm()*v.norm();
    }

    bool isPlane(const int facei) const
    {
        for (const int i : faces[facei])
        {
            const Point u(points[i] - points[faces[facei][0]]);
            if (std::abs(u.dot(normals[facei])) > parallel*u.norm())
            {
                return false;
            }
        }
        return true;
    }
};


// For each face the first of those that it is in one plane with, step by step
// over common edges
std::vector<int> planesOf(const Mesh& mesh)
{
    std::map<Edge, std::vector<int>> facesOf;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Polygon& polygon = mesh.faces[f];
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            facesOf[std::minmax(polygon[i], polygon[(i + 1)%polygon.size()])]
                .push_back(int(f));
        }
    }

    std::vector<int> first(mesh.faces.size());
    std::iota(first.begin(), first.end(), 0);
    const auto root = [&](int f)
    {
        while (first[f] != f)
        {
            f = first[f];
        }
        return f;
    };
    for (const auto& entry : facesOf)
    {
        const std::vector<int>& pair = entry.second;
        if
        (
            pair.size() == 2
         && mesh.kind[pair[0]] == mesh.kind[pair[1]]
         && mesh.isPlane(pair[0]) && mesh.isPlane(pair[1])
         && (mesh.normals[pair[0]] - mesh.normals[pair[1]]).norm() < parallel
        )
        {
            const std::pair<int, int> roots
            (
                std::minmax(root(pair[0]), root(pair[1]))
            );
            first[roots.second] = roots.first;
        }
    }
    for (int& f : first)
    {
        f = root(f);
    }
    return first;
}


// The outline of faces in one plane; empty if it is not a single loop
Polygon outline(const Mesh& mesh, const std::vector<int>& faces)
{
    std::set<Edge> edges;
    for (const int f : faces)
    {
        const Polygon& polygon = mesh.faces[f];
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            const Edge edge(polygon[i], polygon[(i + 1)%polygon.size()]);
            if (!edges.erase({edge.second, edge.first}))
            {
                edges.insert(edge);
            }
        }
    }
    std::map<int, int> next(edges.begin(), edges.end());

    Polygon loop;
    if (next.size() == edges.size())
    {
        int at = next.begin()->first;
        do
        {
            loop.push_back(at);
            const auto to = next.find(at);
            at = to == next.end() ? loop[0] : to->second;
        }
        while (at != loop[0] && loop.size() <= next.size());
    }
    return loop.size() == next.size() ? loop : Polygon();
}


// Is every bend of a loop to the left, about the normal?
bool isConvex(const Mesh& mesh, const Polygon& loop, const Point& normal)
{
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
        const Point& a = mesh.points[loop[i]];
        const Point& b = mesh.points[loop[(i + 1)%loop.size()]];
        const Point& c = mesh.points[loop[(i + 2)%loop.size()]];
        const double length = (b - a).norm()*(c - b).norm();
        if ((b - a).cross(c - b).dot(normal) < -parallel*length)
        {
            return false;
        }
    }
    return true;
}


// Triangles of a convex polygon, of which three points may lie on a line: the
// roundest is cut off first
std::vector<Polygon> triangles(const Mesh& mesh, Polygon polygon)
{
    std::vector<Polygon> result;
    while (polygon.size() >= 3)
    {
        double best = -1;
        std::size_t ear = 0;
        const auto corner = [&](std::size_t i, int k)
        {
            return polygon[(i + polygon.size() + k)%polygon.size()];
        };
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            const Polygon t{corner(i, -1), corner(i, 0), corner(i, 1)};
            Polygon rest(polygon);
            rest.erase(rest.begin() + i);
            const double longest = Foam::sqr(mesh.longestEdge(t));
            const double round = mesh.area(t).norm()/longest;
            const bool leavesArea =
                rest.size() < 3
             || (mesh.area(rest).norm() > parallel*longest && !mesh.isFlat(rest));
            if (leavesArea && round > best)
            {
                best = round;
                ear = i;
            }
        }
        const Polygon t{corner(ear, -1), corner(ear, 0), corner(ear, 1)};
        if (best > parallel && !mesh.isFlat(t))
        {
            result.push_back(t);
        }
        polygon.erase(polygon.begin() + ear);
    }
    return result;
}

}


nscd::Walls<3> Foam::mergedFaces(const wallPieceList<3>& faces)
{
    const Mesh mesh(faces);

    std::map<int, std::vector<int>> planes;
    const std::vector<int> first(planesOf(mesh));
    for (std::size_t f = 0; f < first.size(); ++f)
    {
        planes[first[f]].push_back(int(f));
    }

    // A point goes if it lies on a straight edge of whatever it is part of
    std::map<int, Polygon> loops;
    std::set<int> keep;
    for (const auto& plane : planes)
    {
        const Polygon loop(outline(mesh, plane.second));
        if
        (
            loop.size()
         && mesh.isPlane(plane.first)
         && isConvex(mesh, loop, mesh.normals[plane.first])
        )
        {
            loops[plane.first] = loop;
            for (std::size_t i = 0; i < loop.size(); ++i)
            {
                const int b = loop[(i + 1)%loop.size()];
                if (!mesh.areStraight(loop[i], b, loop[(i + 2)%loop.size()]))
                {
                    keep.insert(b);
                }
            }
        }
        else
        {
            for (const int f : plane.second)
            {
                keep.insert(mesh.faces[f].begin(), mesh.faces[f].end());
            }
        }
    }

    nscd::Walls<3> walls;
    for (const auto& plane : planes)
    {
        const auto add = [&](const Point& a, const Point& b, const Point& c)
        {
            nscd::Triangle wall;
            wall.a = a;
            wall.b = b;
            wall.c = c;
            wall.material = mesh.kind[plane.first].first;
            wall.body = mesh.kind[plane.first].second;
            walls.push_back(wall);
        };
        const auto addPlane = [&](const Polygon& polygon)
        {
            for (const Polygon& t : triangles(mesh, polygon))
            {
                add(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
            }
        };

        if (loops.count(plane.first))
        {
            Polygon corners;
            for (const int i : loops[plane.first])
            {
                if (keep.count(i))
                {
                    corners.push_back(i);
                }
            }
            addPlane(corners);
            continue;
        }
        for (const int f : plane.second)
        {
            const Polygon& polygon = mesh.faces[f];
            if (mesh.isPlane(f))
            {
                addPlane(polygon);
                continue;
            }

            // As the cell behind the face ends
            const Point centre(mesh.average(polygon));
            for (std::size_t i = 0; i < polygon.size(); ++i)
            {
                const Point& a = mesh.points[polygon[i]];
                const Point& b = mesh.points[polygon[(i + 1)%polygon.size()]];
                if ((b - a).cross(centre - a).norm() > mesh.flat*(b - a).norm())
                {
                    add(a, b, centre);
                }
            }
        }
    }
    return walls;
}
