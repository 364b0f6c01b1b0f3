// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Candidates.hpp"
#include "nscd/contact/Impulses.hpp"
#include "nscd/shape/Grains.hpp"
#include "nscd/walls/WallNames.hpp"
#include "nscd/walls/Walls.hpp"

#include <string>

namespace nscd
{

/// All that a run needs to continue as if it had not been interrupted.
template <int D>
struct State
{
    double time = 0;
    Grains<D> grains;

    /// Names of the materials, without line breaks; none in states of materials without names.
    std::vector<std::string> materials;
    Vectors<D> contactImpulse;
    Spins<D> contactSpinImpulse;
    Wrenches<D> unexpected, owed, lasting, earlier;
    double lastTimeStep = 0, lastSubStep = 0;

    /// What the candidate list was made for, and hence the order of the sweeps.
    Vectors<D> candidatePosition;
    Orientations<D> candidateOrientation;
    Reach candidateReach;

    std::vector<NamedImpulse<D>> impulses;

    /// None in states of walls without names.
    WallNames wallNames;

    /// Position, orientation, velocity and spin of the wall bodies; the rest is not saved.
    std::vector<WallBody<D>> wallBodies;

    /// The same when the candidates were listed.
    std::vector<WallBody<D>> candidateWalls;
};

/// Write to a temporary file in the same directory, bring it to disc and rename it: 'file' is either what it was or
/// complete.  Throws std::runtime_error.
template <int D>
void writeState(const std::string& file, const State<D>& state);

/// Throws std::runtime_error naming file and reason: missing, truncated, not such a file, another version or
/// dimension, lists of different lengths, contacts between grains that do not exist.
template <int D>
State<D> readState(const std::string& file);

}  // namespace nscd
