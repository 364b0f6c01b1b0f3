// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>

namespace nscd
{

/// Coefficient of restitution in a fluid, of that without one and the Stokes number m v/(6 pi mu a^2) of the approach,
/// with the reduced mass and radius of the two bodies (doc/theory, eq. 5.20).
using WetRestitution = std::function<double(double restitution, double stokes)>;

}  // namespace nscd
