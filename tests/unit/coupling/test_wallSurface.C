/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "surfaceGaps.H"
#include "wallSurface.H"

#include <random>

using namespace Foam;

namespace
{

// As binary STL files have it
point rounded(const point& p)
{
    return point(float(p.x()), float(p.y()), float(p.z()));
}


// Some rotation of a point in a plane
point turned(const scalar x, const scalar y)
{
    const vector a(0.8, 0.36, 0.48), b(-0.6, 0.48, 0.64);
    return point(0.3, 0.2, 0.1) + x*a + y*b;
}


// Every corner of its own, with seven digits
triSurface surfaceOf(const std::vector<std::array<point, 3>>& facets)
{
    pointField points;
    List<labelledTri> triangles;
    for (const auto& f : facets)
    {
        const label first = points.size();
        for (const point& p : f)
        {
            points.append(rounded(p));
        }
        triangles.append(labelledTri(first, first + 1, first + 2, 0));
    }
    return triSurface(triangles, points);
}


scalar distanceToLine(const point& x, const point& a, const point& b)
{
    const vector along((b - a)/mag(b - a));
    return mag((x - a) - ((x - a) & along)*along);
}


// The corner nearest to a place
point cornerAt(const triSurface& surface, const point& place)
{
    point best(surface.points()[0]);
    for (const labelledTri& t : surface)
    {
        for (const label i : t)
        {
            const point& p = surface.points()[i];
            best = mag(p - place) < mag(best - place) ? p : best;
        }
    }
    return best;
}

}


TEST(WallSurface, CornersOnAnEdgeAreMovedOnToIt)
{
    // An edge of length 1 beside three of a third
    triSurface surface
    (
        surfaceOf
        ({
            {turned(0, 0), turned(0, 1), turned(-1, 0)},
            {turned(0, 0), turned(1, 0), turned(0, 1/3.0)},
            {turned(0, 1/3.0), turned(1, 0), turned(0, 2/3.0)},
            {turned(0, 2/3.0), turned(1, 0), turned(0, 1)}
        })
    );
    const auto worst = [&]
    {
        const point a(cornerAt(surface, turned(0, 0)));
        const point b(cornerAt(surface, turned(0, 1)));
        return max
        (
            distanceToLine(cornerAt(surface, turned(0, 1/3.0)), a, b),
            distanceToLine(cornerAt(surface, turned(0, 2/3.0)), a, b)
        );
    };
    EXPECT_GT(worst(), 1e-9);
    closeGaps(surface);
    EXPECT_LT(worst(), 1e-12);
    EXPECT_EQ(surface.size(), 4);
    EXPECT_EQ(surface.nPoints(), 6);
    for (const labelledTri& t : surface)
    {
        for (const label i : t)
        {
            EXPECT_LT(mag(surface.points()[i] - turned(0, 0)), 1.5);
        }
    }
}


TEST(WallSurface, EdgesThatEndOnOneAnotherMeet)
{
    // From -1 to 0.3 on one side, from -0.3 to 1 on the other
    triSurface surface
    (
        surfaceOf
        ({
            {turned(0, -1), turned(0, 0.3), turned(-1, 0)},
            {turned(0, 1), turned(0, -0.3), turned(1, 0)}
        })
    );
    closeGaps(surface);
    const point a(cornerAt(surface, turned(0, -1))), b(cornerAt(surface, turned(0, 0.3)));
    const point c(cornerAt(surface, turned(0, -0.3))), d(cornerAt(surface, turned(0, 1)));
    EXPECT_LT(distanceToLine(c, a, b), 1e-11);
    EXPECT_LT(distanceToLine(b, c, d), 1e-11);
}


TEST(WallSurface, StaysAsItIsToItsPrecision)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<std::array<point, 3>> facets;
    for (int i = 0; i < 40; ++i)
    {
        std::array<point, 3> f;
        for (point& p : f)
        {
            p = point(uniform(random), uniform(random), uniform(random));
        }
        facets.push_back(f);
    }
    triSurface surface(surfaceOf(facets));
    const pointField before(surface.points());
    closeGaps(surface);
    ASSERT_EQ(surface.size(), 40);
    forAll(surface, i)
    {
        forAll(surface[i], k)
        {
            const point& now = surface.points()[surface[i][k]];
            EXPECT_LT(mag(now - facets[i][k]), 2e-6);
        }
    }
}


TEST(WallSurface, TrianglesWithoutAnExtentGo)
{
    triSurface surface
    (
        surfaceOf
        ({
            {point(0, 0, 0), point(1, 0, 0), point(0, 1, 0)},
            {point(1, 0, 0), point(1 + 1e-7, 0, 0), point(0, 1, 0)}
        })
    );
    closeGaps(surface);
    EXPECT_EQ(surface.size(), 1);
}


TEST(WallSurface, FilesThatAreNotWholeAreNamed)
{
    foamTest::emptyCase one;
    const dictionary dict(foamTest::dict("file a.stl;"));
    const auto read = [&](const std::string& text)
    {
        one.writeFile("a.stl", text);
        return readWallSurface(dict, one.path()/"a.stl");
    };
    const std::string facet
    (
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\n"
    );
    EXPECT_EQ(read("solid a\n" + facet + "endsolid a\n").size(), 1);
    EXPECT_FOAM_ERROR(read("solid a\n" + facet), "a.stl");
    EXPECT_FOAM_ERROR(read("solid a\n" + facet), "endsolid");
    EXPECT_FOAM_ERROR(read("binary"), "it has 6 bytes");

    std::string nan(facet);
    nan.replace(nan.find("1 0 0"), 1, "nan");
    EXPECT_FOAM_ERROR(read("solid a\n" + nan + "endsolid a\n"), "nan");

    const dictionary scaled(foamTest::dict("file a.stl; scale 1e-3;"));
    one.writeFile("a.stl", "solid a\n" + facet + "endsolid a\n");
    const triSurface small(readWallSurface(scaled, one.path()/"a.stl"));
    EXPECT_NEAR(max(mag(small.points())), 1e-3, 1e-15);
    EXPECT_FOAM_ERROR
    (
        readWallSurface(foamTest::dict("file a.stl; scale 0;"), one.path()/"a.stl"), "'scale'"
    );
}
