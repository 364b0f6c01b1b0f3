// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Check.hpp"
#include "nscd/dynamics/ContactDynamics.hpp"

#include <string>

namespace nscd
{

/// Throw std::invalid_argument naming what is wrong, and with which grain, wall or setting.
template <int D>
void validate(const Grains<D>& grains, const ContactTable& table);

/// Walls with the bodies that carry them, at their initial place.  Refused are also segments without length, triangles
/// flatter than 1e-9 of the extent of all triangles, and planes on a body that turns or is free to turn.
template <int D>
void validate(const Walls<D>& walls, const ContactTable& table, const std::vector<WallBody<D>>& bodies);

/// May a wall body have this spin?  A body that carries a plane must not turn.
template <int D>
void checkSpin(const Walls<D>& walls, int body, const Spin<D>& spin);

void validate(const Settings& settings);

/// Do planes lie along a periodic box?  Both must be valid on their own.
template <int D>
void validate(const Settings& settings, const Walls<D>& walls);

/// Is a periodic box wide enough for its grains?  Both must be valid on their own.
template <int D>
void validate(const Settings& settings, const Grains<D>& grains);

void validate(const ContactTable& table);

void checkMaterial(int material, const ContactTable& table, const std::string& owner);

}  // namespace nscd
