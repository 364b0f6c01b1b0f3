/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "injectionRate.H"
#include "patchArea.H"
#include "patchDistance.H"

using namespace Foam;

namespace
{

grainTally grain(const scalar mass)
{
    grainTally one;
    one.number = 1;
    one.mass = mass;
    one.volume = mass/2500;
    return one;
}

label patchOf(const polyMesh& mesh, const word& name)
{
    return mesh.boundaryMesh().findPatchID(name);
}

}


TEST(InjectionRate, OwesTheIntegralOfItsRateLessWhatItPaid)
{
    const dictionary dict
    (
        foamTest::dict
        (
            "massRate table ((0 0) (1 0.2)); start 0.5; end 3; total 0.3;"
        )
    );
    injectionRate rate(dict, 0);
    rate.owe(0.4);
    EXPECT_EQ(rate.owed(), 0);

    // 0.2 t up to 1 s, then the table's last value
    rate.owe(0.75);
    EXPECT_NEAR(rate.owed(), 0.1*(0.75*0.75 - 0.25), 1e-15);
    rate.owe(1);
    EXPECT_NEAR(rate.owed(), 0.075, 1e-15);
    EXPECT_FALSE(rate.owes(grain(0.0751)));
    EXPECT_TRUE(rate.owes(grain(0.075)));
    rate.pay(grain(0.07));
    EXPECT_NEAR(rate.owed(), 0.005, 1e-15);

    // Nothing is due after the end, and no more is paid than in all
    rate.owe(2);
    rate.owe(5);
    EXPECT_NEAR(rate.owed(), 0.005 + 0.4, 1e-14);
    EXPECT_TRUE(rate.owes(grain(0.23)));
    EXPECT_FALSE(rate.owes(grain(0.231)));
}


TEST(InjectionRate, GoesOnFromItsState)
{
    const dictionary dict(foamTest::dict("numberRate 3;"));
    injectionRate one(dict, 0), other(dict, 7);
    one.owe(1);
    one.pay(grain(1));
    dictionary state;
    one.write(state);
    other.read(state);
    one.owe(1.5);
    other.owe(1.5);
    EXPECT_EQ(one.owed(), 3.5);
    EXPECT_EQ(other.owed(), one.owed());
}


TEST(InjectionRate, CountsVolumes)
{
    injectionRate rate(foamTest::dict("volumeRate 1e-3;"), 0);
    rate.owe(1);
    EXPECT_TRUE(rate.owes(grain(2.5)));
    EXPECT_FALSE(rate.owes(grain(2.6)));
}


TEST(PatchArea, OfACubeHasTheSideAndItsRim)
{
    foamTest::blockCase cube({2, 3, 4});
    const grainSpace<3> space(cube.mesh());
    const patchArea<3> area(space, {patchOf(cube.mesh(), "left")});
    EXPECT_TRUE(area.isPlane());
    EXPECT_EQ(area.normal(), vector(1, 0, 0));

    nscd::Random random(2);
    nscd::Vector<3> mean(nscd::Vector<3>::Zero());
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i)
    {
        const nscd::Vector<3> x = area.randomPoint(random);
        mean += x/n;
        EXPECT_NEAR(x[0], 0, 1e-15);
        EXPECT_NEAR
        (
            area.distanceFromRim(x),
            std::min({x[1], 1 - x[1], x[2], 1 - x[2]}),
            1e-12
        );
    }
    // Four standard deviations of the mean of n numbers, of 1/sqrt(12) each
    EXPECT_NEAR(mean[1], 0.5, 4*0.2887/std::sqrt(double(n)));
    EXPECT_NEAR(mean[2], 0.5, 4*0.2887/std::sqrt(double(n)));
    EXPECT_NEAR(area.halfWidth(), 0.5, 0.02);
}


TEST(PatchArea, OfTwoSidesIsNoPlane)
{
    foamTest::blockCase cube({2, 2, 2});
    const grainSpace<3> space(cube.mesh());
    EXPECT_FALSE
    (
        patchArea<3>
        (
            space,
            {patchOf(cube.mesh(), "left"), patchOf(cube.mesh(), "top")}
        ).isPlane()
    );
}


TEST(PatchArea, OfAPlaneHasTwoEnds)
{
    foamTest::planarCase planar(5, 3);
    const grainSpace<2> space(planar.mesh());
    const patchArea<2> area(space, {patchOf(planar.mesh(), "bottom")});
    const nscd::Box<2> box(area.box());
    EXPECT_EQ(space.fromSpace(area.normal()), nscd::Vector<2>(0, 1));
    nscd::Random random(1);
    for (int i = 0; i < 100; ++i)
    {
        const nscd::Vector<2> x = area.randomPoint(random);
        EXPECT_NEAR(x[1], box.lower[1], 1e-15);
        EXPECT_NEAR
        (
            area.distanceFromRim(x),
            std::min(x[0] - box.lower[0], box.upper[0] - x[0]),
            1e-12
        );
    }
}


TEST(PatchDistance, TellsWhichPatchesAreNearest)
{
    foamTest::blockCase cube({2, 3, 4});
    const patchDistance top(cube.mesh(), labelList({patchOf(cube.mesh(), "top")}));
    const pointField x
    ({
        {0.5, 1.2, 0.5}, {0.5, 0.9, 0.5}, {0.5, -0.3, 0.5}, {0.5, 0.45, 0.5},
        {-0.1, 1.1, 0.5}
    });
    const scalarField distances(top.fromPatches(x));
    EXPECT_NEAR(distances[0], 0.2, 1e-12);
    EXPECT_NEAR(distances[2], 1.3, 1e-12);

    // The last one is beyond the edge of two patches
    EXPECT_EQ(top.arePatchesNearest(x), boolList({true, true, false, false, true}));
}
