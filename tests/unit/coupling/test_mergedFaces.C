/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "wallPieces.H"

#include <random>

using namespace Foam;

namespace
{

typedef nscd::Vector<3> Point;

wallFace quad(const Point& a, const Point& u, const Point& v, const int material = 0)
{
    return {{a, a + u, a + u + v, a + v}, material};
}

// A square of side 2 in n x n faces
wallPieceList<3> square(const int n, const Point& corner, const Point& u, const Point& v)
{
    wallPieceList<3> faces;
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            // Exact sums of powers of two
            const double h = 2.0/n;
            faces.push_back(quad(corner + i*h*u + j*h*v, h*u, h*v));
        }
    }
    return faces;
}

// The six sides of a cube of side 2 around the origin, normals outwards
wallPieceList<3> cube(const int n)
{
    wallPieceList<3> faces;
    for (int axis = 0; axis < 3; ++axis)
    {
        const Point u(Point::Unit((axis + 1)%3)), v(Point::Unit((axis + 2)%3));
        const Point corner(-u - v), out(Point::Unit(axis));
        for (const wallFace& f : square(n, corner + out, u, v))
        {
            faces.push_back(f);
        }
        for (const wallFace& f : square(n, corner - out, v, u))
        {
            faces.push_back(f);
        }
    }
    return faces;
}

double area(const nscd::Walls<3>& walls)
{
    double sum = 0;
    for (const auto& wall : walls)
    {
        const nscd::Triangle& t = std::get<nscd::Triangle>(wall);
        sum += (t.b - t.a).cross(t.c - t.a).norm()/2;
    }
    return sum;
}

bool same(const nscd::Walls<3>& one, const nscd::Walls<3>& other)
{
    const auto equal = [](const auto& p, const auto& q)
    {
        const nscd::Triangle& s = std::get<nscd::Triangle>(p);
        const nscd::Triangle& t = std::get<nscd::Triangle>(q);
        return s.a == t.a && s.b == t.b && s.c == t.c && s.material == t.material;
    };
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), equal);
}

}


TEST(MergedFaces, MakeTwoTrianglesOfEachSideOfACube)
{
    for (const int n : {1, 2, 8})
    {
        const nscd::Walls<3> walls(mergedFaces(cube(n)));
        EXPECT_EQ(walls.size(), 12u) << n;
        EXPECT_NEAR(area(walls), 24, 1e-12);
    }
}


TEST(MergedFaces, DoNotDependOnTheOrder)
{
    wallPieceList<3> faces(cube(4));
    faces[3].material = 1;
    const nscd::Walls<3> reference(mergedFaces(faces));
    std::mt19937 random(1);
    for (int trial = 0; trial < 10; ++trial)
    {
        std::shuffle(faces.begin(), faces.end(), random);
        for (wallFace& f : faces)
        {
            std::rotate(f.vertices.begin(), f.vertices.begin() + random()%4, f.vertices.end());
        }
        EXPECT_TRUE(same(mergedFaces(faces), reference));
    }
}


TEST(MergedFaces, KeepMaterialsAndBodiesApart)
{
    const Point x(Point::UnitX()), y(Point::UnitY());
    wallPieceList<3> faces{quad(Point::Zero(), x, y), quad(x, x, y)};
    EXPECT_EQ(mergedFaces(faces).size(), 2u);
    faces[1].material = 1;
    EXPECT_EQ(mergedFaces(faces).size(), 4u);
    faces[1].material = 0;
    faces[1].body = 0;
    const nscd::Walls<3> walls(mergedFaces(faces));
    ASSERT_EQ(walls.size(), 4u);
    EXPECT_EQ(nscd::bodyOf(walls[0]), -1);
    EXPECT_EQ(nscd::bodyOf(walls[3]), 0);
}


TEST(MergedFaces, KeepBendsAndOutlinesThatAreNotConvex)
{
    const Point x(Point::UnitX()), y(Point::UnitY()), z(Point::UnitZ());
    const Point tilted(x + 1e-6*z);
    EXPECT_EQ(mergedFaces({quad(Point::Zero(), x, y), quad(x, tilted, y)}).size(), 4u);

    // An L of three squares
    const wallPieceList<3> l{quad(Point::Zero(), x, y), quad(x, x, y), quad(y, x, y)};
    EXPECT_EQ(mergedFaces(l).size(), 6u);
    EXPECT_NEAR(area(mergedFaces(l)), 3, 1e-14);

    // A square with a hole
    wallPieceList<3> ring(square(4, Point::Zero(), x, y));
    ring.erase(ring.begin() + 5);
    EXPECT_EQ(mergedFaces(ring).size(), 30u);
    EXPECT_TRUE(mergedFaces(wallPieceList<3>()).empty());
}


TEST(MergedFaces, ShareEveryCornerWithTheirNeighbours)
{
    // The long side keeps the vertex in its middle, where two materials meet on the other side
    const Point x(Point::UnitX()), y(Point::UnitY()), z(Point::UnitZ());
    const wallPieceList<3> faces
    {
        quad(Point::Zero(), x, y), quad(x, x, y),
        quad(Point::Zero(), z, x, 1), quad(x, z, x, 2)
    };
    const nscd::Walls<3> walls(mergedFaces(faces));
    EXPECT_EQ(walls.size(), 3u + 2u + 2u);
    EXPECT_NEAR(area(walls), 4, 1e-14);
}


TEST(MergedFaces, DivideAPolygon)
{
    wallFace hexagon;
    for (int i = 0; i < 6; ++i)
    {
        const double a = constant::mathematical::pi*i/3;
        hexagon.vertices.push_back({std::cos(a), std::sin(a), 0});
    }
    const nscd::Walls<3> walls(mergedFaces({hexagon}));
    EXPECT_EQ(walls.size(), 4u);
    EXPECT_NEAR(area(walls), 1.5*std::sqrt(3.0), 1e-14);
}


TEST(MergedFaces, LeaveOutWhatIsNoMoreThanAnEdge)
{
    // A vertex in the middle of an edge, off it by half of what nscd accepts as a triangle's height
    const double off = 5e-10, side = 0.05;
    const wallFace square
    {
        {{0, 0, 0}, {side/2, off, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, 0
    };
    const nscd::Walls<3> walls
    (
        mergedFaces({square, quad({0, 0, 1}, Point::UnitX(), Point::UnitY())})
    );
    EXPECT_EQ(walls.size(), 5u);
    EXPECT_NEAR(area(walls), 1 + sqr(side), side*off);
    for (const auto& wall : walls)
    {
        const auto& t = std::get<nscd::Triangle>(wall);
        EXPECT_GT((t.b - t.a).cross(t.c - t.a).norm(), 1e-9*side);
    }
}


TEST(MergedFaces, DivideWarpedFacesAsTheCellsBehindThem)
{
    // About the average of the vertices: volumes that end at the face end there for grains, too
    const wallFace warped{{{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0}, {0, 1, 0.2}}, 0};
    const nscd::Walls<3> walls(mergedFaces({warped}));
    EXPECT_EQ(walls.size(), 4u);
    for (const auto& wall : walls)
    {
        EXPECT_LT((std::get<nscd::Triangle>(wall).c - Point(0.5, 0.5, 0.1)).norm(), 1e-15);
    }
}
