// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>

namespace nscd
{

/// What conduction through contacts needs to know of a material.
struct ThermalMaterial
{
    double conductivity;   ///< [W/m/K]
    double youngsModulus;  ///< [Pa]
    double poissonRatio;
    double capacity = 0;   ///< rho c [J/m^3/K]; 0: not known, and taken for so large that the surface stays as it is
};

/// Two bodies pressed together: spheres, or cylinders with parallel axes.
struct ThermalContact
{
    ThermalMaterial first, second;
    double firstRadius;   ///< [m]
    double secondRadius;  ///< [m]; infinite: a flat wall
    double force;         ///< with which they press on each other [N]; none conducts nothing
    double length;        ///< of cylinders [m]
};

/// Conductance of a contact [W/K] between the mean temperatures of its bodies; 0 if no force presses them together.
/// Grains are small against the distance over which the temperature varies, and contacts small against grains.
using ConductanceLaw = std::function<double(const ThermalContact&)>;

/// 2/(1/k_i + 1/k_j) [W/m/K] (doc/theory, eq. 6.2).
double meanConductivity(const ThermalContact& contact);

/// Hertz's E*: 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j [Pa] (doc/theory, eq. 6.2).
double effectiveModulus(const ThermalContact& contact);

/// R*: 1/R* = 1/R_i + 1/R_j [m] (doc/theory, eq. 6.2).
double effectiveRadius(const ThermalContact& contact);

/// Radius a of the circle in which two spheres touch: a^3 = 3 F R*/(4 E*) [m] (Johnson, Contact Mechanics, 1985,
/// eq. 4.22; doc/theory, eq. 6.3).
double hertzRadius(const ThermalContact& contact);

/// Half width b of the strip in which two cylinders touch: b^2 = 4 F R*/(pi L E*) [m] (Johnson, eq. 4.43;
/// doc/theory, eq. 6.3).
double hertzHalfWidth(const ThermalContact& contact);

/// Two bodies that hit each other, of effective mass m: 1/m = 1/m_i + 1/m_j [kg], with an impulse [N s].
struct ThermalImpact
{
    double time;          ///< of contact [s]
    double conducted;     ///< heat that passes per difference of the temperatures [J/K]
};

/// Two spheres.  Time 2.87 (m^2/(R* E*^2 v))^(1/5), v = J/(2 m) (Johnson, eq. 11.24); heat as by the law with the mean
/// force, and into what is cold yet (Sun and Chen, Int. J. Heat Mass Transf. 31, 969, 1988; doc/theory, eq. 6.15).
ThermalImpact impactOfSpheres(ThermalContact contact, double mass, double impulse, const ConductanceLaw& law);

/// Two cylinders, a linear spring of pi/4 E* L (doc/theory, eq. 6.15).
ThermalImpact impactOfCylinders(ThermalContact contact, double mass, double impulse, const ConductanceLaw& law);

/// Conductance laws (doc/theory, eq. 6.4 to 6.7).
namespace conductance
{

/// Two spheres: 2 k a (Batchelor and O'Brien, Proc. R. Soc. A 355, 313, 1977).
double spheres(const ThermalContact& contact);

/// Two cylinders, by the constriction of the heat flow towards the strip of contact:
///     1/H = sum over both (ln(2R/b) + 1/8)/(pi k L),
/// exact for b << R, an isothermal strip, a flow that is steady but for uniform heating, and no other contact.  In a
/// wall the flow spreads over the width of the grain, R is the grain's.  b is not taken larger than R.
double strip(const ThermalContact& contact);

/// Discs that stand for spheres: rows of them side by side along the length L.  One pair takes the room of the mean of
/// its diameters; force and conductance are shared out evenly.
double rowOfSpheres(const ThermalContact& contact);

/// Two cylinders after Henry (2025), eq. 4.2, with the length that its print lacks: 2 k s, s the side of a square of
/// the strip's area, s^2 = 2 b L.  Not proportional to the length: the depth of a plane mesh changes the result.
double squarePatch(const ThermalContact& contact);

/// 2 k b: the spot that a circle of the strip's half width would be.  Does not grow with the length at all.
double spot(const ThermalContact& contact);

}  // namespace conductance

}  // namespace nscd
