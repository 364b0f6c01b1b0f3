// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/ball/BallOverlap.hpp"
#include "overlap/mesh/Polyhedron.hpp"

namespace overlap
{

/// Exact intersection of a ball (radius > 0) with a polyhedron.
///
/// A ball that covers the polyhedron returns its volume and centroid.  Otherwise volume and wetted area are sums over
/// the faces of what lies between face and sphere as seen from the ball's centre (divergence theorem; the first moment
/// needs the faces alone, because (|x|^2 - R^2) e_k has the divergence 2 x_k and vanishes on the sphere).  No case is
/// distinguished for the position of vertices and edges (doc/theory, eq. 1.4 to 1.7).
///
/// Errors of volume and wetted area are below 2e-15 of the ball's, those of the first moment below 3e-16 of its volume
/// times radius, each times the distance of the polyhedron's farthest vertex from the centre in radii where that is
/// larger than one (coordinates are rounded to that).  Overlaps much smaller than the ball keep their relative accuracy
/// to 20 eps times the relative change per relative shift of the surfaces that bound them.  The polyhedron may be 1e-3
/// to 1e3 times as large as the ball, and more with these errors.
///
/// The published method is that of Strobl, Formella and Poeschel, J. Comput. Phys. 311 (2016) 158,
/// doi:10.1016/j.jcp.2016.02.003 (inclusion and exclusion of caps and wedges, volume of convex cells).
///
/// Throws std::invalid_argument if the radius is not positive or a number is not finite.
BallOverlap ballPolyhedron(const Point3& centre, double radius, const Polyhedron& cell);

/// Area of each face within the ball [m^2].
std::vector<double> ballFaceAreas(const Point3& centre, double radius, const Polyhedron& cell);

}  // namespace overlap
