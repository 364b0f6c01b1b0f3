/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "lubricationLaw.H"

using namespace Foam;

namespace
{

autoPtr<lubricationLaw> film(const std::string& entries)
{
    return lubricationLaw::New(foamTest::dict("lubrication { " + entries + " }"));
}

}


TEST(LubricationLaw, TakesNothingOfFastImpactsAndAllOfSlowOnes)
{
    for (const char* entries : {"type Legendre;", "type Davis; roughness 1e-3;"})
    {
        const autoPtr<lubricationLaw> law = film(entries);
        EXPECT_NEAR(law->restitution(0.9, 1e9), 0.9, 1e-6);
        EXPECT_LT(law->restitution(0.9, 5), 1e-3);
        EXPECT_EQ(law->restitution(0, 100), 0);
        scalar last = 0;
        for (scalar St = 1; St < 1e4; St *= 1.5)
        {
            const scalar e = law->restitution(0.9, St);
            EXPECT_GE(e, last);
            EXPECT_LT(e, 0.9);
            last = e;
        }
    }
}


TEST(LubricationLaw, HasItsValues)
{
    EXPECT_NEAR(film("type Legendre;")->restitution(1, 35), std::exp(-1.0), 1e-12);
    EXPECT_NEAR(film("type Legendre; beta 0;")->restitution(0.7, 1), 0.7, 1e-12);

    // Speed 1 of Stokes number 20: each way takes ln(100)/20 of it
    const scalar lost = std::log(100.0)/20;
    EXPECT_NEAR
    (
        film("type Davis; roughness 1e-3; reach 0.1;")->restitution(0.8, 20),
        0.8*(1 - lost) - lost,
        1e-12
    );
}


TEST(LubricationLaw, RefusesWhatItDoesNotKnow)
{
    EXPECT_FALSE(lubricationLaw::New(foamTest::dict("")).valid());
    EXPECT_FOAM_ERROR(film("type Stokes;"), "(Davis Legendre)");
    EXPECT_FOAM_ERROR(film("type Davis;"), "'roughness'");
    EXPECT_FOAM_ERROR(film("type Davis; roughness 0;"), "'roughness'");
    EXPECT_FOAM_ERROR(film("type Davis; roughness 1e-2; reach 1e-3;"), "'reach'");
    EXPECT_FOAM_ERROR(film("type Legendre; roughness 1e-3;"), "'roughness'");
}
