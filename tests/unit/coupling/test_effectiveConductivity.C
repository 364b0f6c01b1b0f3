/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "Maxwell.H"
#include "ZehnerSchluender.H"

using namespace Foam;
using namespace Foam::effectiveConductivities;

namespace
{

autoPtr<effectiveConductivity> conductionLaw
(
    const std::string& entries,
    const label nDimensions = 3
)
{
    return effectiveConductivity::New
    (
        foamTest::dict("conductivity { " + entries + " }"), nDimensions
    );
}

const std::vector<std::string> allOfThem{"type Maxwell;", "type ZehnerSchluender;"};

}


TEST(EffectiveConductivity, IsTheFluidsInTheFluidsPartByDefault)
{
    const autoPtr<effectiveConductivity> none = effectiveConductivity::New(dictionary(), 2);
    EXPECT_FALSE(none->needsGrains());
    for (const scalar eps : {0.0, 0.4, 1.0})
    {
        EXPECT_EQ(none->ratio(eps, 10), eps);
    }
}


TEST(EffectiveConductivity, IsThatOfTheFluidWithoutGrainsOrOfGrainsThatConductAlike)
{
    for (const std::string& entries : allOfThem)
    {
        EXPECT_NEAR(conductionLaw(entries)->ratio(1, 10), 1, 1e-14) << entries;
        for (const scalar eps : {0.3, 0.5, 0.9, 0.999})
        {
            EXPECT_NEAR(conductionLaw(entries)->ratio(eps, 1), 1, 1e-14) << entries << eps;
        }
    }
}


TEST(EffectiveConductivity, LiesBetweenSeriesAndParallelAndGrowsWithThatOfTheGrains)
{
    for (const std::string& entries : allOfThem)
    {
        for (const scalar eps : {0.35, 0.45, 0.6, 0.8, 0.95})
        {
            scalar before = 0;
            for (scalar k = 1e-3; k < 1e4; k *= 1.05)
            {
                const scalar r = conductionLaw(entries)->ratio(eps, k);
                EXPECT_GT(r, before) << entries << eps << ' ' << k;
                before = r;
                // Zehner and Schluender's is out by 2e-4 where grains conduct nearly alike,
                // and was not made for suspensions
                if (entries != allOfThem[0] && (mag(std::log(k)) < 0.1 || eps > 0.6))
                {
                    continue;
                }
                EXPECT_GE(r, 1/(eps + (1 - eps)/k)*(1 - 1e-12)) << entries << eps << ' ' << k;
                EXPECT_LE(r, (eps + (1 - eps)*k)*(1 + 1e-12)) << entries << eps << ' ' << k;
            }
        }
    }
}


TEST(EffectiveConductivity, HasTheSlopeOfALoneSphereAndALoneDisc)
{
    // 3 and 2 (k - 1)/(k + 2 and 1), as a dipole has; the second order is some phi
    const scalar phi = 1e-7;
    EXPECT_NEAR((conductionLaw("type Maxwell;")->ratio(1 - phi, 10) - 1)/phi, 27.0/12, 1e-6);
    EXPECT_NEAR((conductionLaw("type Maxwell;", 2)->ratio(1 - phi, 10) - 1)/phi, 18.0/11, 1e-6);
    EXPECT_NEAR
    (
        (conductionLaw("type Maxwell; shape sphere;", 2)->ratio(1 - phi, 10) - 1)/phi, 27.0/12, 1e-6
    );
}


TEST(EffectiveConductivity, HasThePublishedValues)
{
    // Grains that do not conduct: 2 eps/(3 - eps), and 1 - sqrt(phi)
    EXPECT_NEAR(Maxwell::ratio(0.6, 0, 3), 0.8/2.6, 1e-14);
    EXPECT_NEAR(Maxwell::ratio(0.6, 0, 2), 0.4/1.6, 1e-14);
    EXPECT_NEAR(ZehnerSchluender::ratioOf(0.4, 0), 1 - std::sqrt(0.6), 1e-14);
    // Hsu, Cheng and Wong (1994), eq. 1 and 2, by hand
    EXPECT_NEAR(ZehnerSchluender::ratioOf(0.4, 10), 3.6427, 1e-4);
    EXPECT_NEAR(ZehnerSchluender::ratioOf(0.4, 100), 8.8870, 1e-4);
}


TEST(EffectiveConductivity, IsSmoothWhereTheFormulaIsZeroOverZero)
{
    const scalar eps = 0.4;
    const scalar B = 1.25*std::pow(0.6/0.4, 10.0/9.0);
    const scalar at = ZehnerSchluender::ratioOf(eps, B);
    for (const scalar d : {1e-2, 1e-4, 1e-8, 1e-12})
    {
        const scalar above = ZehnerSchluender::ratioOf(eps, B*(1 + d));
        EXPECT_GE(above, at);
        // The slope is below one
        EXPECT_LE(above - at, B*d);
    }
    // From the series to the formula
    const scalar in = ZehnerSchluender::ratioOf(eps, B/(1 - 0.02*(1 - 1e-9)));
    const scalar out = ZehnerSchluender::ratioOf(eps, B/(1 - 0.02*(1 + 1e-9)));
    EXPECT_NEAR(in, out, 1e-9);
}


TEST(EffectiveConductivity, RefusesWhatItDoesNotKnow)
{
    EXPECT_FOAM_ERROR(conductionLaw("type Bruggeman;"), "(Maxwell ZehnerSchluender none)");
    EXPECT_FOAM_ERROR(conductionLaw("type Maxwell; B 1.25;"), "'B'");
    EXPECT_FOAM_ERROR(conductionLaw("type none; shape disc;"), "'shape'");
    EXPECT_FOAM_ERROR(conductionLaw("type ZehnerSchluender;", 2), "shape sphere");
    EXPECT_FOAM_ERROR(conductionLaw("type Maxwell; shape disc;"), "'shape'");
    EXPECT_NO_THROW(conductionLaw("type ZehnerSchluender; shape sphere;", 2));
}
