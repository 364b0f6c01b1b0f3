/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "Batchelor.H"
#include "Einstein.H"
#include "HeleShaw.H"
#include "KriegerDougherty.H"
#include "volFields.H"

using namespace Foam;
using namespace Foam::effectiveViscosities;

namespace
{

autoPtr<effectiveViscosity> law(const std::string& entries)
{
    return effectiveViscosity::New(foamTest::dict("viscosity { " + entries + " }"));
}

}


TEST(EffectiveViscosity, IsTheFluidsInTheFluidsPartByDefault)
{
    const autoPtr<effectiveViscosity> none = effectiveViscosity::New(dictionary());
    for (const scalar eps : {0.0, 0.4, 1.0})
    {
        EXPECT_EQ(none->ratio(eps), eps);
    }
}


TEST(EffectiveViscosity, IsThatOfTheFluidWithoutGrains)
{
    for (const char* entries :
        {
            "type none;", "type Einstein;", "type Batchelor;",
            "type KriegerDougherty; maxFraction 0.64;"
        })
    {
        EXPECT_EQ(law(entries)->ratio(1), 1) << entries;
    }
}


TEST(EffectiveViscosity, HasEinsteinsSlopeInDiluteSuspensions)
{
    const scalar phi = 1e-6;
    const auto slope = [phi](const std::string& entries)
    {
        return (law(entries)->ratio(1 - phi) - 1)/phi;
    };
    // The second order is some 10 phi
    EXPECT_NEAR(slope("type Einstein;"), 2.5, 1e-9);
    EXPECT_NEAR(slope("type Einstein; intrinsic 2;"), 2, 1e-9);
    EXPECT_NEAR(slope("type Batchelor;"), 2.5, 2e-5);
    EXPECT_NEAR(slope("type KriegerDougherty; maxFraction 0.6; exponent 1.5;"), 2.5, 2e-5);
    EXPECT_NEAR(slope("type KriegerDougherty; maxFraction 0.5;"), 4, 2e-5);
}


TEST(EffectiveViscosity, HasThePublishedValues)
{
    // Henry (2025), eq. 3.27 and 3.28, by hand
    EXPECT_NEAR(Batchelor::ratio(0.1, 7.6), 1.326, 1e-12);
    EXPECT_NEAR(KriegerDougherty::ratio(0.32, 0.64, 2, 1000), 4, 1e-12);
    EXPECT_NEAR(KriegerDougherty::ratio(0.576, 0.64, 2, 1000), 100, 1e-10);
    EXPECT_NEAR(Einstein::ratio(0.04, 2.5), 1.1, 1e-14);
}


TEST(EffectiveViscosity, OfADensePackingIsBounded)
{
    const autoPtr<effectiveViscosity> dense =
        law("type KriegerDougherty; maxFraction 0.64; exponent 300; maxRatio 50;");
    scalar before = 1;
    for (scalar phi = 0; phi <= 1; phi += 1e-3)
    {
        const scalar r = dense->ratio(1 - phi);
        EXPECT_GE(r, before);
        EXPECT_LE(r, 50);
        before = r;
    }
    EXPECT_EQ(dense->ratio(0), 50);
}


TEST(EffectiveViscosity, OfAFieldIsThatOfItsCellsAndFaces)
{
    foamTest::planarCase planar(2, 2);
    volScalarField eps
    (
        IOobject("eps", planar.time().timeName(), planar.mesh()),
        planar.mesh(), dimensionedScalar("eps", dimless, 0.9), "zeroGradient"
    );
    eps[3] = 0.5;
    eps.correctBoundaryConditions();
    const volScalarField ratio(law("type Einstein;")->ratio(eps));
    EXPECT_DOUBLE_EQ(ratio[0], 1.25);
    EXPECT_DOUBLE_EQ(ratio[3], 2.25);
    EXPECT_DOUBLE_EQ(gMax(ratio.boundaryField()[1]), 2.25);
}


TEST(EffectiveViscosity, RefusesWhatItDoesNotKnow)
{
    EXPECT_FOAM_ERROR(law("type Krieger;"), "(Batchelor Einstein KriegerDougherty none)");
    EXPECT_FOAM_ERROR(law("type none; intrinsic 2;"), "'intrinsic'");
    EXPECT_FOAM_ERROR(law("type Einstein; intrinsic -1;"), "'intrinsic'");
    EXPECT_FOAM_ERROR(law("type KriegerDougherty;"), "'maxFraction'");
    EXPECT_FOAM_ERROR(law("type KriegerDougherty; maxFraction 64;"), "'maxFraction'");
    EXPECT_FOAM_ERROR(law("type KriegerDougherty; maxFraction 0.6; maxRatio 0.5;"), "'maxRatio'");
}


TEST(HeleShawPlates, GiveTheDragOfAParabolaBetweenThem)
{
    // 12 by 2e-5 by 0.015^-2
    EXPECT_NEAR(2e-5*HeleShawPlates(foamTest::dict("HeleShaw { gap 0.015; }")), 1.0667, 1e-4);
    EXPECT_EQ(HeleShawPlates(dictionary()), 0);
}


TEST(HeleShawPlates, RefuseGapsThatAreNone)
{
    EXPECT_FOAM_ERROR(HeleShawPlates(foamTest::dict("HeleShaw { gap 0; }")), "'gap'");
    EXPECT_FOAM_ERROR(HeleShawPlates(foamTest::dict("HeleShaw { depth 1; }")), "'depth'");
    EXPECT_FOAM_ERROR(HeleShawPlates(foamTest::dict("HeleShaw { }")), "'gap'");
}
