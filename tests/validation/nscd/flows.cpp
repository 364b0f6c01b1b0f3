// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Laws of flowing grains that take minutes to find.

#include "Flows.hpp"

#include <gtest/gtest.h>

TEST(Collapse, FollowsThePowerLawOfStaronAndHinch)
{
    std::vector<double> aspects, lengths;
    for (const double aspect : {4.0, 6.9, 12.0})
    {
        // columns half as wide run out 20 % less far at a = 4: their fronts are a few discs thick
        const RunOut runOut = collapse(aspect, 48, 1);
        EXPECT_NEAR(runOut.overStaronHinch(), 1, 0.2) << "aspect ratio " << runOut.aspect;
        aspects.push_back(runOut.aspect);
        lengths.push_back(runOut.length);
    }
    const auto [power, logarithm] = line(logarithms(aspects), logarithms(lengths));
    std::printf("run-out %.2f a^%.3f widths\n", std::exp(logarithm), power);
    EXPECT_NEAR(power, 0.7, 0.1);
    EXPECT_NEAR(std::exp(logarithm) / 3.25, 1, 0.2);
}

TEST(Discharge, DoesNotDependOnTheHeight)
{
    double first = 0, second = 0;
    for (const double opening : {20.0, 32.0, 50.0})
    {
        const Discharge rate = discharge<2>(opening, 120, 6000, 0.2);
        first += rate.first;
        second += rate.second;
    }
    // between the middles of the two parts the level falls from 0.85 to 0.65: a liquid would slow down by 13 %
    std::printf("rate at the lower level over that at the higher: %.3f\n", second / first);
    EXPECT_NEAR(second / first, 1, 0.05);
}

TEST(Discharge, FollowsBeverlooInThreeDimensions)
{
    std::vector<Discharge> rates;
    for (const double opening : {10.0, 14.0, 20.0})
    {
        rates.push_back(discharge<3>(opening, 40, 10000));
        std::printf("%g d: %.1f and %.1f kg/s\n", opening / 1.8, rates.back().first, rates.back().second);
    }
    // (B - k d)^2.5, where k = 1.5 +- 0.1
    std::printf("exponent %.3f to %.3f\n", exponent(rates, 1.6), exponent(rates, 1.4));
    EXPECT_LT(exponent(rates, 1.6), 2.6);
    EXPECT_GT(exponent(rates, 1.4), 2.4);
}
