// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/clip/PowerCell.hpp"
#include "overlap/mesh/Polyhedron.hpp"

namespace overlap
{

/// The part of a simple polygon in a half-plane, its vertices in the same order; empty if there is none.  Parts that
/// do not hang together are joined by edges that are passed twice, which count for nothing in area and overlap.
std::vector<Point2> clipped(const std::vector<Point2>& polygon, const HalfSpace<2>& half);

/// The part of a polyhedron in a half-space; one of no volume if there is none.
Polyhedron clipped(const Polyhedron& cell, const HalfSpace<3>& half);

}  // namespace overlap
