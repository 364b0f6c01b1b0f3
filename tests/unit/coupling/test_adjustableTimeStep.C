/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "adjustableTimeStep.H"

using namespace Foam;

typedef adjustableTimeStep step;


TEST(AdjustableTimeStep, GrowsByAFifthAtMostAndFallsAtOnce)
{
    EXPECT_DOUBLE_EQ(step::grown(1, 100), 1.2);
    EXPECT_DOUBLE_EQ(step::grown(1, 1.5), 1.15);
    EXPECT_DOUBLE_EQ(step::grown(1, 1.05), 1.05);
    EXPECT_DOUBLE_EQ(step::grown(1, 1), 1);
    EXPECT_DOUBLE_EQ(step::grown(1, 1e-3), 1e-3);
}


TEST(AdjustableTimeStep, MovesABodyByTheDistance)
{
    for (const scalar v : {0.0, 0.1, 20.0})
    {
        for (const scalar a : {1e-3, 9.81})
        {
            const scalar t = step::timeToMove(1e-3, v, a);
            EXPECT_NEAR((v + a*t)*t, 1e-3, 1e-15);
        }
    }
    EXPECT_DOUBLE_EQ(step::timeToMove(1e-3, 0.1, 0), 1e-2);
    EXPECT_EQ(step::timeToMove(1e-3, 0, 0), GREAT);
}


TEST(AdjustableTimeStep, RefusesLimitsThatAreNotPositive)
{
    for (const char* name :
         {"maxCo", "maxGrainCo", "maxGrainDisplacement", "maxDeltaT", "minDeltaT"})
    {
        dictionary dict(foamTest::dict(std::string(name) + " 0;"));
        EXPECT_FOAM_ERROR(step::limits{dict}, name);
    }
    const step::limits defaults((dictionary()));
    EXPECT_FALSE(defaults.adjusts);
    EXPECT_EQ(defaults.maxCo, 1);
    EXPECT_EQ(defaults.maxDeltaT, GREAT);

    dictionary first(foamTest::dict("deltaT 1e-3;"));
    EXPECT_DOUBLE_EQ(step::limits(first).minDeltaT, 1e-9);
    dictionary above(foamTest::dict("deltaT 1e-3; maxDeltaT 1e-3; minDeltaT 2e-3;"));
    EXPECT_FOAM_ERROR(step::limits{above}, "minDeltaT");
}
