/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "closedOutline.H"
#include "grainRegion.H"
#include "nscd/base/Random.hpp"
#include "occupiedSpace.H"

using namespace Foam;

namespace
{

typedef nscd::Vector<2> Vector2;
typedef nscd::Vector<3> Vector3;

// Faces of the cube from 0 to 1, all outwards or all inwards
closedOutline<3> cube(const bool outwards)
{
    wallPieceList<3> faces;
    for (int d = 0; d < 3; ++d)
    {
        const Vector3 u(Vector3::Unit((d + 1) % 3)), v(Vector3::Unit((d + 2) % 3));
        for (const bool isUpper : {false, true})
        {
            const Vector3 o(isUpper ? Vector3(Vector3::Unit(d)) : Vector3(Vector3::Zero()));
            wallFace f;
            f.vertices =
                isUpper == outwards
              ? nscd::Vectors<3>{o, o + u, o + u + v, o + v}
              : nscd::Vectors<3>{o, o + v, o + u + v, o + u};
            faces.push_back(f);
        }
    }
    return closedOutline<3>(faces);
}

}


TEST(ClosedOutline, HoldsBallsThatAreWhollyWithin)
{
    for (const bool outwards : {false, true})
    {
        const closedOutline<3> one(cube(outwards));
        nscd::Random random(1);
        for (int i = 0; i < 2000; ++i)
        {
            const Vector3 x
            (
                random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5)
            );
            const double r = random.uniform(0, 0.4);
            const bool exact = x.minCoeff() >= r && (1 - x.array()).minCoeff() >= r;
            EXPECT_EQ(one.holds(x, r), exact) << x.transpose() << ' ' << r;
        }
    }
}


TEST(ClosedOutline, HoldsDiscsThatAreWhollyWithin)
{
    // A square on its corner, its sides in any direction
    const Vector2 a(1, 0), b(0, 1), c(-1, 0), d(0, -1);
    const closedOutline<2> one({{a, b}, {c, b}, {c, d}, {a, d}});
    nscd::Random random(1);
    for (int i = 0; i < 2000; ++i)
    {
        const Vector2 x(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2));
        const double r = random.uniform(0, 0.5);
        const double depth = (1 - std::abs(x.x()) - std::abs(x.y()))/std::sqrt(2.0);
        EXPECT_EQ(one.holds(x, r), depth >= r) << x.transpose() << ' ' << r;
    }
    // Through a corner
    EXPECT_TRUE(one.holds(Vector2(0, 0), 0.7));
}


TEST(OccupiedSpace, FindsEveryOverlap)
{
    for (const double period : {0.0, 1.0})
    {
        nscd::Random random(2);
        nscd::Grains<2> grains;
        grains.resize(50);
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            grains.position[i] = Vector2(random.uniform(0, 1), random.uniform(0, 1));
            grains.radius[i] = random.uniform(0.005, 0.05);
        }
        const occupiedSpace<2> occupied(grains, {period, 0, 0});
        for (int k = 0; k < 2000; ++k)
        {
            const Vector2 x(random.uniform(-0.5, 1.5), random.uniform(-0.2, 1.2));
            const double r = random.uniform(0.001, 0.1);
            bool isFree = true;
            for (std::size_t i = 0; i < grains.size(); ++i)
            {
                Vector2 apart(x - grains.position[i]);
                apart.x() -= period > 0 ? std::round(apart.x()) : 0;
                isFree = isFree && apart.norm() >= r + grains.radius[i];
            }
            EXPECT_EQ(occupied.isFree(x, r), isFree);
        }
    }
    EXPECT_TRUE(occupiedSpace<3>(nscd::Grains<3>(), {}).isFree(Vector3(0, 0, 0), 1));
}


TEST(GrainRegion, CylinderHoldsWhatIsWithin)
{
    foamTest::blockCase box(Vector<label>(1, 1, 1));
    const grainSpace<3> space(box.mesh());
    const auto region = grainRegion<3>::New
    (
        foamTest::dict("type cylinder; start (0 0 1); end (0 0 3); radius 2;"), space
    );
    EXPECT_TRUE(region->holds(Vector3(0, 0, 2), 1));
    EXPECT_FALSE(region->holds(Vector3(0, 0, 2), 1.01));
    EXPECT_TRUE(region->holds(Vector3(1.2, 0.9, 2), 0.49));
    EXPECT_FALSE(region->holds(Vector3(1.2, 0.9, 2), 0.51));
    EXPECT_FALSE(region->holds(Vector3(0, 0, 4), 0.1));

    foamTest::planarCase planar(1, 1);
    const grainSpace<2> plane(planar.mesh());
    const auto circle = grainRegion<2>::New
    (
        foamTest::dict("type cylinder; start (0 0 0); end (0 0 1); radius 2;"), plane
    );
    EXPECT_TRUE(circle->holds(Vector2(0.6, 0.8), 1));
    EXPECT_FALSE(circle->holds(Vector2(0.6, 0.8), 1.01));
    const auto rectangle = grainRegion<2>::New
    (
        foamTest::dict("type cylinder; start (0 1 0); end (0 3 0); radius 2;"), plane
    );
    EXPECT_TRUE(rectangle->holds(Vector2(1, 2), 1));
    EXPECT_FALSE(rectangle->holds(Vector2(1.1, 2), 1));
    EXPECT_FALSE(rectangle->holds(Vector2(0, 2.1), 1));

    const auto bad = [&](const std::string& text)
    {
        grainRegion<3>::New(foamTest::dict(text), space);
    };
    EXPECT_FOAM_ERROR(bad("type ball;"), "cellZone cylinder surface");
    EXPECT_FOAM_ERROR(bad("type cylinder; start (0 0 1); end (0 0 1); radius 2;"), "'end'");
    EXPECT_FOAM_ERROR(bad("type cylinder; start (0 0 1); end (0 0 2); radius 0;"), "'radius'");
    EXPECT_FOAM_ERROR
    (
        bad("type cylinder; start (0 0 1); end (0 0 2); radius 1; x 1;"), "'x'"
    );
    EXPECT_FOAM_ERROR(bad("type cellZone; zone bed;"), "'zone' has the value bed");
    EXPECT_FOAM_ERROR(bad("type surface; file a.stl;"), "a.stl");
}
