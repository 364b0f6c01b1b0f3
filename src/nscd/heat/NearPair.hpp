// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>
#include <limits>

namespace nscd
{

/// Two bodies near each other, spheres or cylinders with parallel axes, or one and a flat wall.
struct NearPair
{
    double firstRadius;    ///< [m]
    double secondRadius;   ///< [m]; infinite: a flat wall
    double distance;       ///< between centres, or of the centre from the wall [m]
    double length;         ///< of cylinders [m]

    /// What is farther than this from the line of centres, or from the normal of the wall, is left out [m].
    double beside = std::numeric_limits<double>::infinity();
};

/// Conduction through the fluid between near bodies: [W/K] per conductivity of the fluid [W/m/K], that is [m].
/// 'lens': how far heat reaches from a surface sidewise, over the radius; 'leastGap': surfaces are taken to be apart by
/// at least so much [m].
using GapLaw = std::function<double(const NearPair&, double lens, double leastGap)>;

/// Laws of conduction through the fluid (doc/theory, eq. 6.9 to 6.11).
namespace gap
{

/// Between two spheres, or a sphere and a wall: through a layer of fluid along lines parallel to that of the centres,
/// out to where the layer of one (the smaller) that is 'lens' radii thick meets the other's surface.  Rong and Horio,
/// Second Int. Conf. on CFD in the Minerals and Process Industries, Melbourne, 65 (1999); integrated in closed form.
double spheres(const NearPair& pair, double lens, double leastGap);

/// The same between cylinders.
double cylinders(const NearPair& pair, double lens, double leastGap);

/// Discs that stand for spheres: pairs of them side by side along the length.
double rowOfSpheres(const NearPair& pair, double lens, double leastGap);

}  // namespace gap

/// Area over which near bodies see each other, A_1 F_12 = A_2 F_21 [m^2].  Of a wall they see what is not farther than
/// 'farthest' [m] from the centre.
using SightLaw = std::function<double(const NearPair&, double farthest)>;

/// Laws of sight (doc/theory, eq. 6.12 and 6.13).
namespace sight
{

/// Spheres: the solid angle of the other from the centre, a mean of both; up to 11 % too small where equal ones touch.
/// Exact for a wall.
double spheres(const NearPair& pair, double farthest);

/// Cylinders: exact, by crossed strings (Hottel and Sarofim, Radiative Transfer, 1967).
double cylinders(const NearPair& pair, double farthest);

/// Discs that stand for spheres.
double rowOfSpheres(const NearPair& pair, double farthest);

}  // namespace sight

/// Share of black bodies' radiation that grey, diffuse bodies of the same area exchange, 1/(1/e_1 + 1/e_2 - 1)
/// (doc/theory, eq. 6.14).
double greyness(double firstEmissivity, double secondEmissivity);

/// Coefficient of T_2 - T_1 in T_2^4 - T_1^4, times that of Stefan and Boltzmann [W/m^2/K] (doc/theory, eq. 6.14).
double radiationCoefficient(double first, double second);

}  // namespace nscd
