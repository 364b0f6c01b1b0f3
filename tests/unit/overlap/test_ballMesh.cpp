// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Meshes.hpp"
#include "overlap/ball/BallMesh.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

Point3 same(const Point3& p)
{
    return p;
}

/// The same by asking every cell: the largest difference over all cells of volume over the ball's, of wetted area over
/// the sphere's; cells that are in one list alone must be empty to within rounding.
double differenceFromAllCells(const MeshCells& cells, BallMesh& ball, const Point3& centre, double r)
{
    std::vector<BallOverlap> found(cells.cells.size(), BallOverlap{});
    for (const CellOverlap& part : ball.overlaps(centre, r)) found[part.cell] = part;

    double worst = 0;
    for (std::size_t c = 0; c < cells.cells.size(); ++c)
    {
        const BallOverlap x = ballPolyhedron(centre, r, Polyhedron(cells.points, cells.cells[c]));
        worst = std::max({worst, std::abs(x.volume - found[c].volume) / (r * r * r),
                          std::abs(x.wettedArea - found[c].wettedArea) / (r * r)});
    }
    return worst;
}

}  // namespace

TEST(PolyhedralMesh, HasOpenFoamsVolumes)
{
    // A cell of warped quadrangles in OpenFOAM: pyramids from any point to triangles about the average of the vertices
    const MeshCells cells = blockOfKind("warped", 2, {0, 0, 0});
    const PolyhedralMesh mesh = cells.mesh();
    double sum = 0;
    for (std::size_t c = 0; c < mesh.nCells(); ++c)
    {
        double volume = 0;
        for (const std::vector<int>& face : cells.cells[c])
        {
            Point3 average = Point3::Zero();
            for (const int k : face) average += cells.points[k] / 4;
            for (int k = 0; k < 4; ++k)
            {
                volume += cells.points[face[k]].cross(cells.points[face[(k + 1) % 4]]).dot(average) / 6;
            }
        }
        EXPECT_NEAR(mesh.volume(c), volume, 1e-15);
        sum += mesh.volume(c);
    }
    EXPECT_GT(sum, 6);
}

TEST(PolyhedralMesh, RefusesArraysThatAreNoMesh)
{
    const auto make = [](auto change)
    {
        std::vector<Point3> points = box({0, 0, 0}, {1, 1, 1}).vertices;
        std::vector<int> start{0}, vertices, owner(6, 0), neighbour;
        for (const std::vector<int>& face : hexFaces)
        {
            vertices.insert(vertices.end(), face.begin(), face.end());
            start.push_back(static_cast<int>(vertices.size()));
        }
        change(points, start, vertices, owner, neighbour);
        return PolyhedralMesh(points, start, vertices, owner, neighbour).nCells();
    };
    EXPECT_EQ(make([](auto&, auto&, auto&, auto&, auto&) {}), 1);
    EXPECT_THROW(make([](auto& p, auto&, auto&, auto&, auto&) { p[2].y() = INFINITY; }), std::invalid_argument);
    EXPECT_THROW(make([](auto& p, auto&, auto&, auto&, auto&) { p.pop_back(); }), std::invalid_argument);
    EXPECT_THROW(make([](auto&, auto& s, auto&, auto&, auto&) { s[1] = 2; }), std::invalid_argument);
    EXPECT_THROW(make([](auto&, auto& s, auto&, auto&, auto&) { s.pop_back(); }), std::invalid_argument);
    EXPECT_THROW(make([](auto&, auto&, auto& v, auto&, auto&) { v[5] = -1; }), std::invalid_argument);
    EXPECT_THROW(make([](auto&, auto&, auto&, auto& o, auto&) { o[3] = -1; }), std::invalid_argument);
    EXPECT_THROW(make([](auto&, auto&, auto&, auto& o, auto&) { o[3] = 2; }), std::invalid_argument);
    EXPECT_THROW(make([](auto&, auto&, auto&, auto&, auto& n) { n.push_back(0); }), std::invalid_argument);
    EXPECT_THROW(
        make([](auto& p, auto&, auto&, auto&, auto&) { std::swap_ranges(p.begin(), p.begin() + 4, p.begin() + 4); }),
        std::invalid_argument);
}

TEST(BallMesh, FindsWhatAskingEveryCellFinds)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const char* kind : {"aligned", "warped rotated", "rotated tetrahedra"})
    {
        const MeshCells cells = blockOfKind(kind, 4, {0, 0, 0});
        const PolyhedralMesh mesh = cells.mesh();
        BallMesh ball(mesh);
        for (int k = 0; k < 60; ++k)
        {
            // Also balls that reach out of the mesh, and such that have their centres outside
            const Point3 centre = 3 * Point3(unit(random), unit(random), unit(random));
            const double r = std::pow(10, unit(random));
            EXPECT_LT(differenceFromAllCells(cells, ball, centre, r), 2e-14) << kind << ' ' << r;
        }
    }
}

TEST(BallMesh, GradedMeshesKeepThePartition)
{
    // Cells from 1e-3 to 1 side by side, balls from smaller than the smallest to larger than the largest
    const int n = 24;
    const auto grade = [](double x) { return std::copysign(std::expm1(0.5 * std::abs(x)) / 100, x); };
    const PolyhedralMesh mesh = block(n, false,
                                      [&](const Point3& p) -> Point3 {
                                          return {grade(p.x()), grade(p.y()), grade(p.z())};
                                      })
                                    .mesh();
    BallMesh ball(mesh);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int k = 0; k < 300; ++k)
    {
        const double r = std::pow(10, 1.5 * unit(random) - 2);
        const Point3 centre = Point3(unit(random), unit(random), unit(random)) * std::pow(10, unit(random) - 1);
        long double volume = 0;
        for (const CellOverlap& part : ball.overlaps(centre, r)) volume += part.volume;
        EXPECT_NEAR(static_cast<double>(volume / (4 * pi / 3 * r * r * r)), 1, 1e-14) << r;
    }
}

TEST(BallMesh, PartsOfADomainAddUpToTheWhole)
{
    // Two ranks, each with cells that do not touch each other
    const auto isBlack = [](int i, int j, int k) { return (i / 2 + j / 3 + k) % 2 == 0; };
    const PolyhedralMesh whole = block(6, false, same).mesh(), black = block(6, false, same, isBlack).mesh(),
                         white = block(6, false, same, [&](int i, int j, int k) { return !isBlack(i, j, k); }).mesh();
    ASSERT_EQ(black.nCells() + white.nCells(), whole.nCells());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int k = 0; k < 200; ++k)
    {
        const Point3 centre = 3.5 * Point3(unit(random), unit(random), unit(random));
        const double r = std::pow(10, unit(random) - 0.3);
        double volumes[3] = {0, 0, 0};
        const PolyhedralMesh* meshes[] = {&whole, &black, &white};
        for (int m = 0; m < 3; ++m)
        {
            BallMesh ball(*meshes[m]);
            for (const CellOverlap& part : ball.overlaps(centre, r)) volumes[m] += part.volume;
        }
        EXPECT_NEAR(volumes[1] + volumes[2], volumes[0], 1e-14 * 4 * pi / 3 * r * r * r);
    }
}

TEST(BallMesh, BallsOutsideHaveTheirPartInside)
{
    const PolyhedralMesh mesh = block(4, false, same).mesh();
    BallMesh ball(mesh);
    const double r = 1.3;
    for (const double h : {0.0, 0.2, 0.9, 1.25})
    {
        double volume = 0;
        for (const CellOverlap& part : ball.overlaps({2 + h, 0.1, -0.2}, r)) volume += part.volume;
        EXPECT_NEAR(volume, pi * (r - h) * (r - h) * (2 * r + h) / 3, 1e-14) << h;
    }
    EXPECT_TRUE(ball.overlaps({3.4, 0, 0}, r).empty());
    EXPECT_TRUE(ball.overlaps({-50, 70, 90}, r).empty());

    double all = 0;
    for (const CellOverlap& part : ball.overlaps({0, 0, 0}, 100)) all += part.volume;
    EXPECT_NEAR(all, 64, 1e-12);
}

TEST(BallMesh, FaceAreasAddUpToTheSectionOfTheBall)
{
    const PolyhedralMesh mesh = block(6, false, same).mesh();
    BallMesh ball(mesh);
    ball.overlaps({0.3, 0.2, 0.6}, 1.9);
    double area = 0;
    for (std::size_t f = 0; f < mesh.nFaces(); ++f)
    {
        const Facet& facet = *mesh.facets().begin(f);
        const bool isInPlane = facet.origin.z() == 0 && std::abs(facet.normal.z()) == 1;
        if (isInPlane) area += ball.faceArea(static_cast<int>(f));
    }
    EXPECT_NEAR(area, pi * (1.9 * 1.9 - 0.36), 2e-14);
}

TEST(BallMesh, FollowsAMeshThatMoves)
{
    MeshCells cells = block(4, false, same);
    PolyhedralMesh mesh = cells.mesh();
    BallMesh ball(mesh);
    for (Point3& p : cells.points) p += 0.1 * Point3(std::sin(3 * p.y()), std::sin(2 * p.z()), std::sin(4 * p.x()));
    mesh.movePoints(cells.points);
    EXPECT_LT(differenceFromAllCells(cells, ball, {0.3, 0.1, -0.2}, 0.8), 1e-14);
    EXPECT_THROW(mesh.movePoints({}), std::invalid_argument);
}

TEST(BallMesh, AHintChangesNothing)
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const char* kind : {"rotated", "warped rotated"})
    {
        const PolyhedralMesh mesh = blockOfKind(kind, 4, {0, 0, 0}).mesh();
        BallMesh plain(mesh), hinted(mesh);
        for (int k = 0; k < 600; ++k)
        {
            const Point3 centre = Point3(unit(random), unit(random), unit(random));
            const double r = k % 2 ? 0.05 : 0.4;
            const std::vector<CellOverlap>& a = plain.overlaps(centre, r);
            const int hint = k % 3 ? a[0].cell : static_cast<int>(random() % (mesh.nCells() + 10)) - 1;
            const std::vector<CellOverlap>& b = hinted.overlaps(centre, r, hint);
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i)
            {
                EXPECT_EQ(a[i].cell, b[i].cell);
                EXPECT_EQ(a[i].volume, b[i].volume);
                EXPECT_EQ(a[i].centroid, b[i].centroid);
            }
        }
    }
}

TEST(BallMesh, BallsInAndBesideADentedCell)
{
    // The notch of the L is within the reach of the cell in front of its own planes
    const Cell cell = extrudedL();
    const Polyhedron ell(cell.vertices, cell.faces);
    const double r = 0.2, whole = 4 * pi / 3 * r * r * r;
    const std::pair<Point3, double> balls[] = {
        {{0.5, 0.5, 0.5}, 1}, {{1.5, 0.5, 0.5}, 1},   {{0.5, 1.5, 0.5}, 1}, {{1.5, 1.5, 0.5}, 0}, {{1.2, 1.2, 0.5}, 0},
        {{1, 1.5, 0.5}, 0.5}, {{1.5, 1, 0.5}, 0.5},   {{1, 1, 0.5}, 0.75},  {{2.5, 0.5, 0.5}, 0}, {{0.5, 2.5, 0.5}, 0},
        {{2, 0.5, 0.5}, 0.5}, {{1.5, 1, 1}, 0.25},    {{2, 1, 1}, 0.125},   {{2, 2, 0.5}, 0},     {{1, 1, 1}, 0.375},
    };
    for (const auto& [centre, share] : balls)
    {
        EXPECT_NEAR(ballPolyhedron(centre, r, ell).volume, share * whole, 1e-15) << centre.transpose();
    }
}

TEST(BallMesh, FacesWithoutAreaHideNoCell)
{
    // Two of the cells have a triangle between them whose vertices are on an edge of both
    MeshCells cells = block(2, false, same);
    const int a = 1, b = 4, middle = static_cast<int>(cells.points.size());
    cells.points.push_back(0.5 * (cells.points[a] + cells.points[b]));
    cells.cells[0].push_back({a, b, middle});
    cells.cells[1].push_back({middle, b, a});
    const PolyhedralMesh mesh = cells.mesh();
    BallMesh ball(mesh);
    const double r = 0.3, whole = 4 * pi / 3 * r * r * r;
    for (const double x : {-0.5, -0.1, 0.05, 0.5})
    {
        double volume = 0;
        for (const CellOverlap& part : ball.overlaps({x, -0.5, -0.5}, r)) volume += part.volume;
        EXPECT_NEAR(volume, whole, 1e-14 * whole) << x;
    }
}

TEST(BallMesh, RefusesBallsWithoutRadius)
{
    const PolyhedralMesh mesh = block(2, false, same).mesh();
    BallMesh ball(mesh);
    EXPECT_THROW(ball.overlaps({0, 0, 0}, 0), std::invalid_argument);
    EXPECT_THROW(ball.overlaps({0, INFINITY, 0}, 1), std::invalid_argument);
}
