// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Invalid operations, divisions by zero and overflows stop the tests, as they stop an OpenFOAM program.

#include <cfenv>
#include <gtest/gtest.h>

namespace
{

class FloatTraps : public testing::Environment
{
public:
    void SetUp() override { feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); }
};

const testing::Environment* const floatTraps = testing::AddGlobalTestEnvironment(new FloatTraps);

}  // namespace
