// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Cells.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

constexpr double fourThirdsPi = 4 * pi / 3;

void expectNear(const Point3& got, const Point3& expected, double tolerance)
{
    EXPECT_LT((got - expected).norm(), tolerance) << got.transpose() << " instead of " << expected.transpose();
}

}  // namespace

TEST(Polyhedron, HasVolumeAndCentroid)
{
    const Cell cell = tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4});
    const Polyhedron tet(cell.vertices, cell.faces);
    EXPECT_NEAR(tet.volume(), 4, 4e-15);
    expectNear(tet.centroid(), {0.5, 0.75, 1}, 1e-15);
}

TEST(Polyhedron, KeepsItsDigitsFarFromTheOrigin)
{
    const Point3 far(1e3, -2e3, 3e3);
    const Cell cell = box(far, far + Point3::Constant(0x1p-6));
    const Polyhedron cube(cell.vertices, cell.faces);
    EXPECT_NEAR(cube.volume() * 0x1p18, 1, 1e-15);
}

TEST(Polyhedron, WarpedFacesAreFansAboutTheAverageOfTheirVertices)
{
    // One corner lifted by z: each of the top's four triangles about the average spans a quarter of the square, and the
    // average of the lift over them is z/4; the sides' fans lie in planes
    const double z = 0.3;
    Cell cell = box({0, 0, 0}, {1, 1, 1});
    cell.vertices[6].z() += z;
    EXPECT_NEAR(Polyhedron(cell.vertices, cell.faces).volume(), 1 + z / 4, 1e-15);
}

TEST(Polyhedron, RefusesWhatIsNotAClosedSurface)
{
    const Cell cube = box({0, 0, 0}, {1, 1, 1});
    Faces open(cube.faces.begin(), cube.faces.end() - 1), inward = cube.faces, unknown = cube.faces;
    for (std::vector<int>& face : inward) std::reverse(face.begin(), face.end());
    unknown[2][1] = 8;
    std::vector<Point3> infinite = cube.vertices;
    infinite[3].x() = INFINITY;

    EXPECT_THROW(Polyhedron(cube.vertices, open), std::invalid_argument);
    EXPECT_THROW(Polyhedron(cube.vertices, inward), std::invalid_argument);
    EXPECT_THROW(Polyhedron(cube.vertices, unknown), std::invalid_argument);
    EXPECT_THROW(Polyhedron(infinite, cube.faces), std::invalid_argument);
    EXPECT_THROW(Polyhedron(cube.vertices, {{0, 1}}), std::invalid_argument);
}

TEST(BallPolyhedron, RefusesBallsWithoutRadius)
{
    const Cell cube = box({0, 0, 0}, {1, 1, 1});
    for (const double radius : {0.0, -1.0, double(INFINITY), double(NAN)})
    {
        EXPECT_THROW(ballCell({0, 0, 0}, radius, cube), std::invalid_argument);
    }
    EXPECT_THROW(ballCell({0, NAN, 0}, 1, cube), std::invalid_argument);
}

TEST(BallPolyhedron, BallWithinTheCellIsTheBallExactly)
{
    for (const double r : {1e-9, 0.3, 0.499})
    {
        const BallOverlap x = ballCell({0.5, 0.5, 0.5}, r, box({0, 0, 0}, {1, 1, 1}));
        EXPECT_EQ(x.volume, fourThirdsPi * r * r * r);
        EXPECT_EQ(x.centroid, Point3(0.5, 0.5, 0.5));
        EXPECT_EQ(x.wettedArea, 4 * pi * r * r);
        EXPECT_EQ(x.wettedVector, Point3(0, 0, 0));
    }
}

TEST(BallPolyhedron, CoveredCellIsTheCellExactly)
{
    const Cell cell = tetrahedron({0.1, 0, 0}, {0.3, 0.1, 0}, {0.2, 0.5, 0}, {0, 0, 0.4});
    const Polyhedron tet(cell.vertices, cell.faces);
    const BallOverlap x = ballPolyhedron({0, 0, 0}, 1, tet);
    EXPECT_EQ(x.volume, tet.volume());
    EXPECT_EQ(x.centroid, tet.centroid());
    EXPECT_EQ(x.wettedArea, 0);
    const std::vector<double> areas = ballFaceAreas({0, 0, 0}, 1, tet);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(areas[k], tet.view().facets.faceArea(k), 2e-16);
}

TEST(BallPolyhedron, DisjointPairIsEmptyAndItsCentroidTheCentre)
{
    const Point3 centre(7, 8, 9);
    for (const Cell& cell : {box({0, 0, 0}, {1, 1, 1}), box({7.6, 8.6, 9.6}, {9, 9, 10})})
    {
        const BallOverlap x = ballCell(centre, 1, cell);
        EXPECT_EQ(x.volume, 0);
        EXPECT_EQ(x.wettedArea, 0);
        EXPECT_EQ(x.centroid, centre);
    }
}

TEST(BallPolyhedron, CentreOnFaceEdgeAndVertexGivesHalfQuarterAndEighth)
{
    for (const double e : {0.0, 1e-16, 1e-12})
    {
        const BallOverlap half = unitBallIn(box({e, -2, -3}, {2, 3, 4}));
        const BallOverlap quarter = unitBallIn(box({e, e, -3}, {2, 3, 4}));
        const BallOverlap eighth = unitBallIn(box({e, e, e}, {2, 3, 4}));
        const double shift = 4 * e;  // areas of the faces times e
        EXPECT_NEAR(half.volume, fourThirdsPi / 2, 2e-15 + shift);
        EXPECT_NEAR(quarter.volume, fourThirdsPi / 4, 2e-15 + shift);
        EXPECT_NEAR(eighth.volume, fourThirdsPi / 8, 2e-15 + shift);
        EXPECT_NEAR(half.wettedArea, 2 * pi, 8e-15 + 9 * e);
        EXPECT_NEAR(quarter.wettedArea, pi, 8e-15 + 9 * e);
        EXPECT_NEAR(eighth.wettedArea, pi / 2, 8e-15 + 9 * e);
        expectNear(half.centroid, {3. / 8, 0, 0}, 4e-15 + shift);
        expectNear(quarter.centroid, {3. / 8, 3. / 8, 0}, 4e-15 + shift);
        expectNear(eighth.centroid, {3. / 8, 3. / 8, 3. / 8}, 4e-15 + shift);
        expectNear(eighth.wettedVector, {pi / 4, pi / 4, pi / 4}, 4e-15 + shift);
    }
}

TEST(BallPolyhedron, HalfSpaceGivesACap)
{
    for (const double h : {-0.999, -0.5, -1e-3, 0.0, 1e-8, 0.01, 0.0199, 0.0201, 0.2, 0.7, 0.99, 0.999999})
    {
        const Cell cell = box({h, -5, -5}, {5, 5, 5});
        const BallOverlap x = unitBallIn(cell);
        const double volume = pi * (1 - h) * (1 - h) * (2 + h) / 3, area = pi * (1 - h) * (1 + h);
        const double moment = area * area / (4 * pi);
        const double tolerance = std::min(2e-15, 1e-13 * volume + 1e-15 * area);
        EXPECT_NEAR(x.volume, volume, tolerance) << h;
        EXPECT_NEAR(x.volume * x.centroid.x(), moment, 2e-15) << h;
        EXPECT_NEAR(x.wettedArea, 2 * pi * (1 - h), 4e-15) << h;
        expectNear(x.wettedVector, {area, 0, 0}, 2e-15);
        EXPECT_NEAR(ballFaceAreas({0, 0, 0}, 1, Polyhedron(cell.vertices, cell.faces))[5], area, 2e-15) << h;
    }
}

TEST(BallPolyhedron, SixFacesThatCutLeaveSixCaps)
{
    const double h = 0.9;
    const BallOverlap x = unitBallIn(box(Point3::Constant(-h), Point3::Constant(h)));
    EXPECT_NEAR(x.volume, fourThirdsPi - 6 * pi * (1 - h) * (1 - h) * (2 + h) / 3, 4e-15);
    EXPECT_NEAR(x.wettedArea, 4 * pi - 6 * 2 * pi * (1 - h), 1e-14);
    expectNear(x.centroid, {0, 0, 0}, 1e-15);
}

TEST(BallPolyhedron, WedgeHasItsAngle)
{
    // Two planes through the centre's axis at an angle a: the part a/(2 pi) of the ball
    for (const double a : {1e-6, 0.01, 0.3, 1.0, 2.5})
    {
        const Point3 x(5, 0, 0), y(5 * std::cos(a), 5 * std::sin(a), 0), z(0, 0, 5);
        const Cell prism{{-z, x - z, y - z, z, x + z, y + z},
                         {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
        EXPECT_NEAR(unitBallIn(prism).volume, 2. / 3 * a, 3e-15) << a;
        EXPECT_NEAR(unitBallIn(prism).wettedArea, 2 * a, 1e-14) << a;
    }
}

TEST(BallPolyhedron, InscribedCellIsCoveredAndCircumscribedCellHoldsTheBall)
{
    const double s = 1 / std::sqrt(3.);
    EXPECT_NEAR(unitBallIn(box(Point3::Constant(-s), Point3::Constant(s))).volume, 8 * s * s * s, 1e-15);
    EXPECT_NEAR(unitBallIn(box({-1, -1, -1}, {1, 1, 1})).volume, fourThirdsPi, 2e-15);
    EXPECT_NEAR(unitBallIn(box({-1, -1, -1}, {1, 1, 1})).wettedArea, 4 * pi, 8e-15);
}

TEST(BallPolyhedron, ContactInAPointIsEmpty)
{
    const double s = std::sqrt(0.5), t = 1 / std::sqrt(3.);
    const Cell cells[] = {box({-0.1, -0.1, -1.1}, {0, 0, -1}),
                          box({-1, -1, 1}, {2, 3, 4}),
                          box({1, 0, 0}, {2, 1, 1}),
                          box({s, s, -1}, {2, 2, 2}),
                          box({t, t, t}, {1, 2, 3}),
                          box({0.6, 0.8, 0}, {2, 2, 2}),
                          tetrahedron({1, 0, 0}, {2, 1, 0}, {2, -1, 0.5}, {2, 0, -1})};
    for (const Cell& cell : cells)
    {
        EXPECT_NEAR(unitBallIn(cell).volume, 0, 1e-15);
        EXPECT_NEAR(unitBallIn(cell).wettedArea, 0, 1e-14);
    }
}

TEST(BallPolyhedron, NearlyTangentFaceIsContinuous)
{
    for (const double e : {1e-5, 1e-8, 1e-12, 1e-15, 3e-16})
    {
        const double cap = pi * e * e * (3 - e) / 3;
        const double height = 1 - (1 - e);  // as rounded
        const double rounded = pi * height * height * (3 - height) / 3;
        const BallOverlap x = unitBallIn(box({1 - e, -2, -2}, {3, 2, 2}));
        EXPECT_NEAR(x.volume / rounded, 1, 1e-13) << e;
        EXPECT_NEAR(x.wettedArea / (2 * pi * height), 1, 1e-13) << e;
        EXPECT_NEAR(unitBallIn(box({-3, -2, -2}, {1 - e, 2, 2})).volume, fourThirdsPi - cap, 2e-15);
        EXPECT_EQ(unitBallIn(box({1 + e, -2, -2}, {3, 2, 2})).volume, 0);
        EXPECT_EQ(unitBallIn(box({-3, -2, -2}, {1 + e, 2, 2})).volume, fourThirdsPi);
    }
}

TEST(BallPolyhedron, NonConvexCellIsTheSumOfItsConvexParts)
{
    const Cell cell = extrudedL();
    for (const double x : {-0.5, 0.0, 0.5, 0.99, 1.0, 1.3, 1.7})
    {
        for (const double y : {-0.4, 0.3, 1.0, 1.2})
        {
            for (const double z : {-0.3, 0.0, 0.5, 0.8})
            {
                for (const double r : {0.05, 0.3, 0.5, 1.0, 1.5, 4.0})
                {
                    const Point3 c(x, y, z);
                    const BallOverlap whole = ballCell(c, r, cell);
                    const BallOverlap foot = ballCell(c, r, box({0, 0, 0}, {2, 1, 1}));
                    const BallOverlap leg = ballCell(c, r, box({0, 1, 0}, {1, 2, 1}));
                    EXPECT_NEAR(whole.volume, foot.volume + leg.volume, 2e-15 * fourThirdsPi * std::max(r * r * r, 1.));
                    EXPECT_NEAR(whole.wettedArea, foot.wettedArea + leg.wettedArea,
                                2e-15 * 4 * pi * std::max(r * r, 1.));
                    const Point3 moment = whole.volume * (whole.centroid - c) - foot.volume * (foot.centroid - c)
                                          - leg.volume * (leg.centroid - c);
                    EXPECT_LT(moment.norm(), 2e-15 * fourThirdsPi * std::max(std::pow(r, 4), 1.));
                }
            }
        }
    }
}

TEST(BallPolyhedron, BallInTheHollowOfACellDoesNotOverlap)
{
    // A frame around the z axis: outer and inner walls, top and bottom in four pieces each
    std::vector<Point3> v;
    for (const double s : {3., 2.})
    {
        for (const double z : {-3., 3.})
        {
            for (const Point2& p : {Point2(-s, -s), Point2(s, -s), Point2(s, s), Point2(-s, s)})
                v.emplace_back(p.x(), p.y(), z);
        }
    }
    Faces faces;
    for (int k = 0; k < 4; ++k)
    {
        const int n = (k + 1) % 4;
        faces.push_back({k, n, n + 4, k + 4});
        faces.push_back({n + 8, k + 8, k + 12, n + 12});
        faces.push_back({n, k, k + 8, n + 8});
        faces.push_back({k + 4, n + 4, n + 12, k + 12});
    }
    const Polyhedron frame(v, faces);
    EXPECT_NEAR(frame.volume(), 6 * (36 - 16), 1e-13);
    EXPECT_EQ(ballPolyhedron({0.5, 0, 0}, 1, frame).volume, 0);
    EXPECT_NEAR(ballPolyhedron({2, 0, 0}, 1, frame).volume, fourThirdsPi / 2, 4e-15);
    EXPECT_EQ(ballPolyhedron({2.5, 0, 0}, 0.4, frame).volume, fourThirdsPi * 0.4 * 0.4 * 0.4);
}

TEST(BallPolyhedron, VolumeMovesByAreaTimesDisplacement)
{
    // Moving the ball by d changes the volume by the wetted vector times d, to second order; no jumps anywhere
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    const Cell cells[] = {box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {3, 3, 3}),
                          tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
    for (const Cell& cell : cells)
    {
        const Polyhedron polyhedron(cell.vertices, cell.faces);
        for (int path = 0; path < 300; ++path)
        {
            // On to and across vertices, edges and faces
            const Point3 target = path % 3 ? Point3(cell.vertices[path % cell.vertices.size()])
                                           : Point3(0.5 * (cell.vertices[0] + cell.vertices[1]));
            const Point3 d = 1e-9 * Point3(unit(random), unit(random), unit(random));
            const double r = path % 2 ? 0.7 : 1.0;
            BallOverlap before = ballPolyhedron(target - 10 * d, r, polyhedron);
            for (int step = -9; step <= 10; ++step)
            {
                const BallOverlap x = ballPolyhedron(target + step * d, r, polyhedron);
                const double expected = 0.5 * (before.wettedVector + x.wettedVector).dot(d);
                EXPECT_NEAR(x.volume - before.volume, expected, 3e-15 * fourThirdsPi + 10 * d.squaredNorm());
                EXPECT_LT((x.centroid - before.centroid).norm(), 20 * d.norm());
                before = x;
            }
        }
    }
}

TEST(BallPolyhedron, FacesAndWettedSurfaceClose)
{
    const Cell cell = tetrahedron({-0.3, -0.2, -0.4}, {1.5, 0.1, 0}, {0.2, 1.7, 0.3}, {0.1, 0.2, 1.4});
    const Polyhedron tet(cell.vertices, cell.faces);
    const BallOverlap x = ballPolyhedron({0.1, 0.2, 0}, 1, tet);
    const std::vector<double> areas = ballFaceAreas({0.1, 0.2, 0}, 1, tet);
    Point3 sum = x.wettedVector;
    for (std::size_t k = 0; k < 4; ++k) sum += areas[k] * tet.view().facets.begin(k)->normal;
    EXPECT_LT(sum.norm(), 2e-15);
}
