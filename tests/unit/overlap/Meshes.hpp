// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Cells.hpp"
#include "overlap/mesh/PolyhedralMesh.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <string>

namespace overlap
{

/// Points, and cells as lists of faces, from which the arrays of a polyMesh are made.
struct MeshCells
{
    std::vector<Point3> points;
    std::vector<Faces> cells;

    PolyhedralMesh mesh() const
    {
        struct Face
        {
            std::vector<int> loop;
            int owner, neighbour;
        };
        std::vector<Face> faces;
        std::map<std::vector<int>, std::size_t> known;
        for (std::size_t c = 0; c < cells.size(); ++c)
        {
            for (const std::vector<int>& loop : cells[c])
            {
                std::vector<int> key = loop;
                std::sort(key.begin(), key.end());
                const auto [entry, isNew] = known.emplace(key, faces.size());
                if (isNew)
                {
                    faces.push_back({loop, static_cast<int>(c), -1});
                }
                else
                {
                    faces[entry->second].neighbour = static_cast<int>(c);
                }
            }
        }
        std::stable_partition(faces.begin(), faces.end(), [](const Face& f) { return f.neighbour >= 0; });

        std::vector<int> start{0}, vertices, owner, neighbour;
        for (const Face& face : faces)
        {
            vertices.insert(vertices.end(), face.loop.begin(), face.loop.end());
            start.push_back(static_cast<int>(vertices.size()));
            owner.push_back(face.owner);
            if (face.neighbour >= 0) neighbour.push_back(face.neighbour);
        }
        return PolyhedralMesh(points, start, vertices, owner, neighbour);
    }
};

/// n x n x n unit cubes about the origin, their points mapped; each split into six tetrahedra if asked for; cells whose
/// index (i, j, k) is not kept are left out.
inline MeshCells block(
    int n, bool tetrahedra, const std::function<Point3(const Point3&)>& map,
    const std::function<bool(int, int, int)>& keep = [](int, int, int) { return true; })
{
    MeshCells mesh;
    for (int k = 0; k <= n; ++k)
    {
        for (int j = 0; j <= n; ++j)
        {
            for (int i = 0; i <= n; ++i) mesh.points.push_back(map(Point3(i - n / 2, j - n / 2, k - n / 2)));
        }
    }
    const auto point = [n](int i, int j, int k) { return i + (n + 1) * (j + (n + 1) * k); };
    for (int k = 0; k < n; ++k)
    {
        for (int j = 0; j < n; ++j)
        {
            for (int i = 0; i < n; ++i)
            {
                if (!keep(i, j, k)) continue;
                const int v[] = {
                    point(i, j, k),     point(i + 1, j, k),     point(i + 1, j + 1, k),     point(i, j + 1, k),
                    point(i, j, k + 1), point(i + 1, j, k + 1), point(i + 1, j + 1, k + 1), point(i, j + 1, k + 1)};
                const auto add = [&](const Faces& local, const std::vector<int>& corners)
                {
                    Faces cell = local;
                    for (std::vector<int>& face : cell)
                    {
                        for (int& corner : face) corner = v[corners[corner]];
                    }
                    mesh.cells.push_back(cell);
                };
                if (!tetrahedra)
                {
                    add(hexFaces, {0, 1, 2, 3, 4, 5, 6, 7});
                    continue;
                }
                // Along the diagonal 0-6, one for each order of the three axes
                for (const auto& path : std::vector<std::vector<int>>{
                         {0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}})
                {
                    add(tetFaces, path);
                }
            }
        }
    }
    return mesh;
}

/// What a mesh of unit cubes is made into: the words aligned, rotated, warped and tetrahedra.
inline MeshCells blockOfKind(const std::string& kind, int n, const Point3& origin)
{
    const auto has = [&](const char* word) { return kind.find(word) != std::string::npos; };
    std::mt19937 random(7);
    const double warp = has("warped") ? 0.15 : 0;
    std::uniform_real_distribution<double> unit(-1, 1);
    const Eigen::Matrix3d turn = has("rotated") ? randomRotation(random) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    return block(n, has("tetrahedra"),
                 [&](const Point3& p) -> Point3
                 { return turn * (p + warp * Point3(unit(random), unit(random), unit(random))) + origin; });
}

}  // namespace overlap
