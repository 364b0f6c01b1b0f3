/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "writingTimes.H"

using namespace Foam;


TEST(WritingTimes, DividesATimeIntoWholeStepsThatAreNeverLonger)
{
    EXPECT_DOUBLE_EQ(writingTimes::dividing(10, 3), 2.5);
    EXPECT_DOUBLE_EQ(writingTimes::dividing(10, 2.5), 2.5);
    EXPECT_DOUBLE_EQ(writingTimes::dividing(1, 3), 1);
    for (const scalar deltaT : {0.0123456789, 0.3, 0.099999})
    {
        const scalar divided = writingTimes::dividing(1, deltaT);
        EXPECT_LE(divided, deltaT*(1 + 1e-9));
        EXPECT_NEAR(std::remainder(1, divided), 0, 1e-14);
    }
}


TEST(WritingTimes, PutsTimesWhereSumsAndDifferencesAreExact)
{
    for (const scalar interval : {0.02, 0.3, 7.7})
    {
        const scalar spacing = writingTimes::onGrid(interval, interval);
        EXPECT_NEAR(spacing/interval, 1, 1e-12);
        // The same interval, counted from zero and from a time on the grid
        const scalar start = 4093*spacing;
        for (const scalar deltaT : {1.23e-4, 0.7e-6})
        {
            const scalar time = writingTimes::onGrid(start + deltaT, interval);
            EXPECT_EQ(start + (time - start), time);
            EXPECT_EQ(4094*spacing - time, spacing - (time - start));
        }
    }
}
