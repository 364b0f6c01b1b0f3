// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace nscd
{

constexpr double pi = 3.14159265358979323846;

}  // namespace nscd
