/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "planarCells.H"
#include "spatialCells.H"
#include "voidFractionMethod.H"
#include "volFields.H"

using namespace Foam;

namespace
{

autoPtr<voidFractionMethod> diffused(const grainCells& cells, const std::string& entries)
{
    return voidFractionMethod::New(foamTest::dict("type diffused; " + entries), cells);
}

// Vertices inside the unit cube moved by up to a tenth of its side
point skewed(const point& x)
{
    const scalar bump = x.x()*(1 - x.x())*x.y()*(1 - x.y());
    return x + bump*vector(0.4, -0.5, 0);
}

scalarField pattern(const label n, const scalar phase)
{
    scalarField x(n);
    forAll(x, i)
    {
        x[i] = std::sin(7.3*i + phase);
    }
    return x;
}

}


class Diffusion
:
    public ::testing::Test
{
protected:

    foamTest::planarCase planar{12, 9, boundBox(point(0, 0, 0), point(1, 1, 0.1)), skewed};
    planarMesh plane{planar.mesh()};
    planarCells cells{plane};
    const scalarField& V = planar.mesh().V();
};


TEST_F(Diffusion, KeepsIntegralsAndConstants)
{
    const auto method = diffused(cells, "length 0.2;");
    scalarField x(pattern(V.size(), 0));
    const scalar before = sum(V*x);
    method->smooth(x);
    EXPECT_NEAR(sum(V*x), before, 1e-12*sum(V*mag(x)));

    scalarField one(V.size(), 1.0);
    method->smooth(one);
    EXPECT_NEAR(gMin(one), 1, 1e-12);
    EXPECT_NEAR(gMax(one), 1, 1e-12);
}


TEST_F(Diffusion, IsItsOwnAdjoint)
{
    const auto method = diffused(cells, "length 0.3; steps 2;");
    const scalarField a(pattern(V.size(), 0)), b(pattern(V.size(), 1));
    scalarField Sa(a), Sb(b);
    method->smooth(Sa);
    method->smooth(Sb);
    EXPECT_NEAR(sum(V*a*Sb), sum(V*Sa*b), 1e-12*sum(V));
    EXPECT_GT(mag(sum(V*a*Sb)), 1e-6);
}


TEST_F(Diffusion, MakesNothingNegative)
{
    const auto method = diffused(cells, "length 0.1;");
    scalarField x(V.size(), Zero);
    x[50] = 1;
    method->smooth(x);
    EXPECT_GT(gMin(x), 0);
    EXPECT_LT(gMax(x), 1);
}


TEST_F(Diffusion, SpreadsTheComponentsThatTheMeshHas)
{
    const auto method = diffused(cells, "length 0.2;");
    scalarField x(pattern(V.size(), 0));
    vectorField u(V.size(), Zero);
    u.replace(0, x);
    u.replace(1, 2*x);
    u.replace(2, x);
    method->smooth(u);
    const scalarField z(x);
    method->smooth(x);
    EXPECT_EQ(gMax(mag(u.component(0)() - x)()), 0);
    EXPECT_LE(gMax(mag(u.component(1)() - 2*x)()), 1e-12);
    EXPECT_EQ(gMax(mag(u.component(2)() - z)()), 0);
}


TEST_F(Diffusion, OverAShortLengthIsTheExactOverlap)
{
    const auto method = diffused(cells, "length 1e-9;");
    const scalarField before(pattern(V.size(), 0));
    scalarField x(before);
    method->smooth(x);
    // b^2/4 over the square of the smallest cell, 0.05
    EXPECT_LE(gMax(mag(x - before)()), 1e-12);
}


TEST_F(Diffusion, LeavesTheOverlapsExact)
{
    grainBodies grains;
    grains.centre = pointField(1, point(0.5, 0.5, 0.05));
    grains.radius = scalarField(1, 0.3);
    grains.start = labelList({0, 1});
    grains.member = List<grainMember>(1, grainMember{grains.centre[0], 0.3});
    overlapList overlaps, exact;
    for (overlapList* list : {&overlaps, &exact})
    {
        list->clear();
        list->endGrain();
    }
    diffused(cells, "length 0.2;")->map(grains, overlaps);
    voidFractionMethod::New(foamTest::dict("type exactOverlap;"), cells)->map(grains, exact);
    EXPECT_EQ(overlaps.cell, exact.cell);
    EXPECT_EQ(overlaps.volume, exact.volume);
    EXPECT_NEAR(sum(overlaps.volume)/cells.volume(0.3), 1, 1e-13);
}


TEST(DiffusionInSpace, HasTheVarianceOfTheKernel)
{
    // In cells of one size the discrete operator has it exactly, as long as no wall is near
    const label n = 30;
    foamTest::blockCase block(Vector<label>(n, n, n));
    const spatialCells cells(block.mesh());
    const scalar b = 0.05;
    for (const std::string steps : {"1", "3"})
    {
        const auto method = diffused(cells, "length 0.05; steps " + steps + ";");
        scalarField x(n*n*n, Zero);
        const label middle = n/2 + n*(n/2 + n*(n/2));
        x[middle] = 1;
        method->smooth(x);
        const vectorField arm(block.mesh().C().primitiveField() - block.mesh().C()[middle]);
        for (direction d = 0; d < 3; ++d)
        {
            // Walls are 13 b away, where a single implicit step has left exp(-2 13)
            EXPECT_NEAR(sum(x*sqr(arm.component(d)()))/(sqr(b)/2), 1, 1e-6) << steps;
        }
        EXPECT_NEAR(sum(x), 1, 1e-12);
    }
}


TEST(Diffused, RefusesWhatItDoesNotKnow)
{
    foamTest::planarCase planar(2, 2);
    const planarMesh plane(planar.mesh());
    const planarCells cells(plane);
    EXPECT_FOAM_ERROR(diffused(cells, "length 0;"), "'length'");
    EXPECT_FOAM_ERROR(diffused(cells, "length 1; steps 0;"), "'steps'");
    EXPECT_FOAM_ERROR(diffused(cells, "length 1; width 1;"), "'width'");
}
