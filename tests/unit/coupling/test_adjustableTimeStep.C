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


TEST(AdjustableTimeStep, DividesATimeIntoWholeStepsThatAreNeverLonger)
{
    EXPECT_DOUBLE_EQ(step::dividing(10, 3), 2.5);
    EXPECT_DOUBLE_EQ(step::dividing(10, 2.5), 2.5);
    EXPECT_DOUBLE_EQ(step::dividing(1, 3), 1);
    EXPECT_DOUBLE_EQ(step::dividing(GREAT, 3), 3);
    for (const scalar deltaT : {0.0123456789, 0.3, 0.099999})
    {
        const scalar divided = step::dividing(1, deltaT);
        // Ten digits are kept
        EXPECT_LE(divided, deltaT*(1 + 1e-9));
        EXPECT_NEAR(std::remainder(1, divided), 0, 1e-8);
    }
}


TEST(AdjustableTimeStep, DoesNotSeeTheRoundOffOfATime)
{
    for (const scalar time : {0.04, 0.3, 7.7})
    {
        EXPECT_EQ(step::dividing(time, 1.23e-3), step::dividing(time*(1 + 4e-16), 1.23e-3));
    }
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
    for (const char* name : {"maxCo", "maxGrainCo", "maxGrainDisplacement", "maxDeltaT"})
    {
        dictionary dict(foamTest::dict(std::string(name) + " 0;"));
        EXPECT_FOAM_ERROR(step::limits{dict}, name);
    }
    const step::limits defaults((dictionary()));
    EXPECT_FALSE(defaults.adjusts);
    EXPECT_EQ(defaults.maxCo, 1);
    EXPECT_EQ(defaults.maxDeltaT, GREAT);
}
