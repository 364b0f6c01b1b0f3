/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "Kader.H"
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


TEST(WallHeat, IsThatOfTheLogLawFarFromTheWall)
{
    // Air, water, oil
    for (const scalar Pr : {0.7, 7.0, 100.0})
    {
        const scalar y = 1000;
        const scalar beta = sqr(3.85*std::cbrt(Pr) - 1.3) + 2.12*std::log(Pr);
        const scalar T = 2.12*std::log(y) + beta;
        EXPECT_NEAR(wallHeatRatio(y, Pr), Pr*y/T, 0.01*Pr*y/T) << Pr;
    }
}


TEST(WallHeat, GrowsAsShearDoesWithTurbulentPrandtlNumber)
{
    // T+ rises by Prt times what u+ does in the log layer, Prt 0.85
    for (const scalar Pr : {0.7, 7.0})
    {
        const auto T = [&](const scalar y) { return Pr*y/wallHeatRatio(y, Pr); };
        EXPECT_NEAR((T(3000) - T(300))*0.41/std::log(10), 0.85, 0.03) << Pr;
    }
}


TEST(WallHeat, IsConductionNearTheWall)
{
    // Where its parts take over from each other the profile is below both: ratios go
    // back by 2 to 17 %
    constexpr scalar dip = 0.175;

    for (const scalar Pr : {0.006, 0.7, 7.0, 1000.0, 4e4})
    {
        EXPECT_EQ(wallHeatRatio(0, Pr), 1);
        EXPECT_NEAR(wallHeatRatio(0.2*std::pow(Pr, -0.4), Pr), 1, 0.01) << Pr;
        scalar largest = 1;
        for (scalar y = 1e-6; y < 1e5; y *= 1.1)
        {
            const scalar ratio = wallHeatRatio(y, Pr);
            EXPECT_GE(ratio, largest*(1 - dip)) << Pr << ' ' << y;
            largest = max(largest, ratio);
        }
        EXPECT_GE(largest, Pr < 0.1 ? 5 : 100) << Pr;
    }
}
