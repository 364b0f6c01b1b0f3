// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "BallOracle.hpp"
#include "Meshes.hpp"
#include "overlap/clip/Clip.hpp"
#include "Shapes.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

HalfSpace<3> randomHalfSpace(std::mt19937& random, double reach)
{
    std::uniform_real_distribution<double> unit(-reach, reach);
    return {randomRotation(random).col(0), Point3(unit(random), unit(random), unit(random))};
}

HalfSpace<3> opposite(const HalfSpace<3>& half)
{
    return {-half.normal, half.point};
}

Polyhedron ell()
{
    const Cell cell = extrudedL();
    return Polyhedron(cell.vertices, cell.faces);
}

Polyhedron warpedCell()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-0.2, 0.2);
    const Cell cell =
        mapped(box({0, 0, 0}, {1, 1, 1}),
               [&](const Point3& p) -> Point3 { return p + Point3(unit(random), unit(random), unit(random)); });
    return Polyhedron(cell.vertices, cell.faces);
}

}  // namespace

TEST(Clip, CutsACornerOffACube)
{
    const Cell cube = box({0, 0, 0}, {1, 1, 1});
    const Polyhedron polyhedron(cube.vertices, cube.faces);
    for (const double s : {0.2, 0.5, 1.0})
    {
        const HalfSpace<3> corner{Point3::Constant(1 / std::sqrt(3.)), {s, 0, 0}};
        const Polyhedron part = clipped(polyhedron, corner);
        EXPECT_NEAR(part.volume(), s * s * s / 6, 1e-16);
        EXPECT_LT((part.centroid() - Point3::Constant(s / 4)).norm(), 1e-15);
        EXPECT_NEAR(clipped(polyhedron, opposite(corner)).volume(), 1 - s * s * s / 6, 3e-16);
    }
}

TEST(Clip, HalfSpacesThatHoldAllOrNothing)
{
    const Cell cube = box({0, 0, 0}, {1, 1, 1});
    const Polyhedron polyhedron(cube.vertices, cube.faces);
    for (const double x : {1.0, 1.5})
    {
        EXPECT_DOUBLE_EQ(clipped(polyhedron, {{1, 0, 0}, {x, 0, 0}}).volume(), 1);
        EXPECT_EQ(clipped(polyhedron, {{-1, 0, 0}, {x, 0, 0}}).volume(), 0);
    }
    EXPECT_EQ(ballPolyhedron({0, 0, 0}, 1, clipped(polyhedron, {{1, 0, 0}, {-1, 0, 0}})).volume, 0);
    EXPECT_TRUE(clipped(rectangle(0, 0, 1, 1), HalfSpace<2>{{1, 0}, {-1, 0}}).empty());
}

TEST(Clip, BothSidesAddUpToTheWholeForNonConvexCellsTwice)
{
    std::mt19937 random(5);
    for (const Polyhedron& cell : {ell(), warpedCell()})
    {
        for (int k = 0; k < 2000; ++k)
        {
            const HalfSpace<3> a = randomHalfSpace(random, 1), b = randomHalfSpace(random, 1);
            double volume = 0;
            Point3 moment = Point3::Zero();
            for (const HalfSpace<3>& first : {a, opposite(a)})
            {
                for (const HalfSpace<3>& second : {b, opposite(b)})
                {
                    const Polyhedron part = clipped(clipped(cell, first), second);
                    volume += part.volume();
                    moment += part.volume() * part.centroid();
                }
            }
            EXPECT_NEAR(volume, cell.volume(), 1e-14);
            EXPECT_LT((moment - cell.volume() * cell.centroid()).norm(), 1e-14);
        }
    }
}

TEST(Clip, BallInBothSidesAddsUpToTheBallInTheCell)
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 2);
    for (const Polyhedron& cell : {ell(), warpedCell()})
    {
        for (int k = 0; k < 2000; ++k)
        {
            const Point3 centre(unit(random), unit(random), unit(random));
            const double r = 0.2 + std::abs(unit(random));
            const BallOverlap whole = ballPolyhedron(centre, r, cell);
            const HalfSpace<3> a = randomHalfSpace(random, 1), b = randomHalfSpace(random, 1);
            double volume = 0, area = 0;
            for (const HalfSpace<3>& first : {a, opposite(a)})
            {
                for (const HalfSpace<3>& second : {b, opposite(b)})
                {
                    const BallOverlap part = ballPolyhedron(centre, r, clipped(clipped(cell, first), second));
                    volume += part.volume;
                    area += part.wettedArea;
                }
            }
            EXPECT_NEAR(volume / (r * r * r), whole.volume / (r * r * r), 4e-14);
            EXPECT_NEAR(area / (r * r), whole.wettedArea / (r * r), 1e-13);
        }
    }
}

TEST(Clip, PlanesOfFacesEdgesAndVerticesAreNoException)
{
    // Lattice planes through a lattice cube
    const Cell cube = box({0, 0, 0}, {1, 1, 1});
    const Polyhedron polyhedron(cube.vertices, cube.faces);
    for (int x = -1; x <= 1; ++x)
    {
        for (int y = -1; y <= 1; ++y)
        {
            for (int z = -1; z <= 1; ++z)
            {
                if (x == 0 && y == 0 && z == 0) continue;
                for (const Point3& point : {Point3(0, 0, 0), Point3(1, 1, 1), Point3(0, 1, 0), Point3(0.5, 0.5, 0.5)})
                {
                    const HalfSpace<3> half{Point3(x, y, z).normalized(), point};
                    const Polyhedron a = clipped(polyhedron, half), b = clipped(polyhedron, opposite(half));
                    EXPECT_NEAR(a.volume() + b.volume(), 1, 1e-15);
                    const double inA = ballPolyhedron({0, 0, 0}, 0.75, a).volume;
                    const double inB = ballPolyhedron({0, 0, 0}, 0.75, b).volume;
                    EXPECT_NEAR(inA + inB, pi / 6 * 0.75 * 0.75 * 0.75, 2e-15);
                }
            }
        }
    }
}

TEST(Clip, PolygonsFollowTheSameRules)
{
    const Polygon comb = {{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1},
                          {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    const Polygon teeth = clipped(comb, HalfSpace<2>{{0, -1}, {0, 1.5}});
    EXPECT_NEAR(polygon(teeth).area, 1.5, 1e-15);
    for (const double x : {0.5, 1.5, 2.5, 4.5})
    {
        const Point2 centre(x, 1.7);
        const double area = discPolygon(centre, 0.6, comb).area;
        const double above = discPolygon(centre, 0.6, teeth).area;
        const double below = discPolygon(centre, 0.6, clipped(comb, HalfSpace<2>{{0, 1}, {0, 1.5}})).area;
        EXPECT_NEAR(above + below, area, 2e-15);
    }
}
