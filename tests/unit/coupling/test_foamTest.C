/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "fvcGrad.H"
#include "volFields.H"

using namespace Foam;

TEST(PlanarCase, HasEmptyFrontAndBackAndFourWalls)
{
    foamTest::planarCase planar(4, 3);
    const fvBoundaryMesh& patches = planar.mesh().boundary();

    for (const char* name : {"left", "right", "bottom", "top"})
    {
        EXPECT_EQ(patches[name].type(), "wall") << name;
    }
    EXPECT_EQ(patches["left"].size(), 3);
    EXPECT_EQ(patches["top"].size(), 4);
    EXPECT_EQ(patches["front"].patch().size(), 12);
    EXPECT_EQ(patches["front"].type(), "empty");
    EXPECT_EQ(patches["back"].type(), "empty");
    EXPECT_EQ(planar.mesh().nGeometricD(), 2);
}


TEST(PlanarCase, FillsItsBox)
{
    foamTest::planarCase planar(5, 2, boundBox(point(-1, 0, 0), point(1, 3, 0.1)));
    EXPECT_NEAR(gSum(planar.mesh().V()), 0.6, 1e-14);
    EXPECT_GT(min(planar.mesh().V()).value(), 0);
    EXPECT_NEAR(planar.mesh().C()[0].x(), -0.8, 1e-14);
}


TEST(PlanarCase, MovesVerticesByTheMap)
{
    foamTest::planarCase sheared
    (
        3, 3, boundBox(point::zero, point::one),
        [](const point& p) { return point(p.x() + p.y(), p.y(), p.z()); }
    );
    EXPECT_NEAR(sheared.mesh().C()[8].x(), 5.0/6 + 5.0/6, 1e-14);
}


TEST(PlanarCase, HasAnExactLinearGradient)
{
    foamTest::planarCase planar(8, 8);
    const volScalarField x("x", planar.mesh().C().component(vector::X));
    const volVectorField gradX(fvc::grad(x));
    EXPECT_NEAR(gradX[8*4 + 4].x(), 1, 1e-12);
}


TEST(FatalErrors, AreExceptionsWithTheirMessage)
{
    const dimensionedScalar p("p", dimPressure, 1), u("u", dimVelocity, 1);
    EXPECT_FOAM_ERROR(p + u, "dimensions");
    EXPECT_FOAM_ERROR(foamTest::dict("a 1;").get<scalar>("b"), "b");
}


TEST(Parallel, SumsOverTheRanks)
{
    EXPECT_EQ(returnReduce(label(1), sumOp<label>()), Pstream::nProcs());
}


TEST(Parallel, EveryRankHasItsOwnCase)
{
    foamTest::planarCase planar(2 + Pstream::myProcNo(), 2);
    EXPECT_EQ(planar.mesh().nCells(), 2*(2 + Pstream::myProcNo()));
}
