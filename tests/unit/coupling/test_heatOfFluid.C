/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "enthalpy.H"
#include "poorConductors.H"

using namespace Foam;

TEST(PoorConductors, PartOfATriangleIsThatOfALinearFunction)
{
    const auto part = poorConductors::negativePart;
    EXPECT_EQ(part(1, 2, 3), 0);
    EXPECT_EQ(part(-1, -2, -3), 1);
    // A corner cut off at half of both sides, in any order; and its complement
    EXPECT_DOUBLE_EQ(part(-1, 1, 1), 0.25);
    EXPECT_DOUBLE_EQ(part(1, -1, 1), 0.25);
    EXPECT_DOUBLE_EQ(part(1, 1, -1), 0.25);
    EXPECT_DOUBLE_EQ(part(-1, 1, -1), 0.75);
    // Along a side, and through a corner
    EXPECT_EQ(part(0, 0, 1), 0);
    EXPECT_EQ(part(0, 0, -1), 1);
    EXPECT_DOUBLE_EQ(part(-1, 0, 1), 0.5);
    EXPECT_DOUBLE_EQ(part(-1, 0, 3), 0.25);
}


TEST(Enthalpy, IsTheIntegralOfALinearCapacity)
{
    const dictionary dict(foamTest::dict("Cp polynomial ((200 0) (3 1));"));
    const enthalpy H(dict);
    const scalar c = 200 + 3*300;
    const auto exact = [&](const scalar T)
    {
        return 300 + (200*(T - 300) + 1.5*(sqr(T) - sqr(300.0)))/c;
    };
    // Upwards, downwards, and again
    for (const scalar T : {300.0, 512.25, 1500.5, 77.125, 299.999, 300.001, 1500.5, 2.5})
    {
        EXPECT_NEAR(H.of(T), exact(T), 1e-12*exact(1500));
        EXPECT_NEAR(H.slope(T), (200 + 3*T)/c, 1e-12);
        EXPECT_NEAR(H.value(H.of(T)), T, 1e-9);
    }
}


TEST(Enthalpy, OfAConstantCapacityIsTheTemperature)
{
    const dictionary dict(foamTest::dict("Cp table ((200 900) (600 900));"));
    const enthalpy H(dict);
    EXPECT_NEAR(H.of(250.5), 250.5, 1e-12);
    EXPECT_NEAR(H.of(599), 599, 1e-12);
    EXPECT_EQ(H.slope(400.25), 1);
}


TEST(Enthalpy, RefusesCapacitiesThatAreNotPositive)
{
    const dictionary dict(foamTest::dict("Cp polynomial ((-400 0) (1 1));"));
    EXPECT_FOAM_ERROR(const enthalpy H(dict), "value -100 at 300 K");
}
