/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "fvc.H"
#include "surfaceFields.H"
#include "volFields.H"

using namespace Foam;

// OpenFOAM writes such results over one of the factors: see Make/options

TEST(InPlaceProducts, OfTemporariesAreThoseOfFields)
{
    foamTest::planarCase planar(9, 7);
    const fvMesh& mesh = planar.mesh();
    const volVectorField x(mesh.C());
    const volTensorField A
    (
        x*x + dimensionedTensor("A", dimArea, tensor(1, 2, 3, 4, 5, 6, 7, 8, 10))
    );

    const volVectorField product(A & x);
    const volVectorField inPlace
    (
        tmp<volTensorField>(new volTensorField(A)) & tmp<volVectorField>(new volVectorField(x))
    );
    EXPECT_EQ(inPlace.primitiveField(), product.primitiveField());

    const volTensorField deviator(dev2(T(A)));
    const volTensorField deviatorInPlace(dev2(T(tmp<volTensorField>(new volTensorField(A)))));
    EXPECT_EQ(deviatorInPlace.primitiveField(), deviator.primitiveField());
}


TEST(Reconstruct, IsExactForAUniformFieldOnSkewedCells)
{
    foamTest::planarCase skewed
    (
        6, 6, boundBox(point::zero, point::one),
        [](const point& p) { return point(p.x() + 0.4*p.y(), p.y() + 0.2*p.x()*p.x(), p.z()); }
    );
    const fvMesh& mesh = skewed.mesh();
    const dimensionedVector g("g", dimless, vector(2, -3, 0));
    const volVectorField found(fvc::reconstruct(g & mesh.Sf()));
    EXPECT_LT(gMax(mag(found - g)().primitiveField()), 1e-12);
}
