/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "Spalding.H"

using namespace Foam;

namespace
{

//- Spalding's y+ of a u+
scalar yPlus(const scalar u)
{
    const scalar k = 0.41*u;
    return u + (std::exp(k) - 1 - k - sqr(k)/2 - pow3(k)/6)/9.8;
}

}


TEST(WallShear, FollowsSpaldingsProfile)
{
    for (scalar u = 0.01; u < 70; u *= 1.3)
    {
        const scalar y = yPlus(u);
        EXPECT_NEAR(wallShearRatio(u*y), y/u, 1e-10*y/u);
    }
}


TEST(WallShear, IsThatOfTheLogLawFarFromTheWall)
{
    // At y+ 1000 within 3 %, as OpenFOAM's nutUWallFunction has it
    const scalar y = 1000;
    const scalar u = std::log(9.8*y)/0.41;
    EXPECT_NEAR(wallShearRatio(u*y), y/u, 0.03*y/u);
}


TEST(WallShear, IsLaminarNearTheWall)
{
    EXPECT_EQ(wallShearRatio(0), 1);
    EXPECT_NEAR(wallShearRatio(1e-20), 1, 1e-12);
    EXPECT_NEAR(wallShearRatio(1), 1, 1e-3);
    EXPECT_NEAR(wallShearRatio(25), 1, 0.05);
    scalar last = 0;
    for (scalar Re = 1e-3; Re < 1e15; Re *= 2)
    {
        const scalar ratio = wallShearRatio(Re);
        EXPECT_GE(ratio, last);
        last = ratio;
    }
}
