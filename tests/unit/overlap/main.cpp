// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <cfenv>
#include <gtest/gtest.h>

int main(int argc, char* argv[])
{
    ::testing::InitGoogleTest(&argc, argv);
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);  // as OpenFOAM does
    return RUN_ALL_TESTS();
}
