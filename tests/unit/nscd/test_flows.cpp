// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Laws of flowing grains in two dimensions; the validation has them with more grains and in three.

#include "Flows.hpp"

#include <gtest/gtest.h>

TEST(Collapse, RunsOutAsStaronAndHinchFound)
{
    // 3.25 a^0.7 for friction 1; twenty per cent is what packings of 1200 discs differ by
    const RunOut runOut = collapse(4, 30, 1);
    RecordProperty("runOut", std::to_string(runOut.length));
    EXPECT_NEAR(runOut.overStaronHinch(), 1, 0.2);
}

TEST(Discharge, FollowsBeverlooInTwoDimensions)
{
    std::vector<Discharge> rates;
    for (const double opening : {20.0, 32.0, 50.0})
    {
        rates.push_back(discharge<2>(opening, 120, 6000));
    }
    // (B - k d)^1.5, where k = 1.5 +- 0.1 (Nedderman 1992, Statics and kinematics of granular materials)
    RecordProperty("exponent", std::to_string(exponent(rates, 1.6)) + " to " + std::to_string(exponent(rates, 1.4)));
    EXPECT_LT(exponent(rates, 1.6), 1.6);
    EXPECT_GT(exponent(rates, 1.4), 1.4);
}
