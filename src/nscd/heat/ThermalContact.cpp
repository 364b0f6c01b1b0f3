// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/ThermalContact.hpp"

#include "nscd/base/Pi.hpp"

#include <algorithm>
#include <cmath>

namespace nscd
{

namespace
{

double compliance(const ThermalMaterial& material)
{
    return (1 - material.poissonRatio * material.poissonRatio) / material.youngsModulus;
}

double pressing(const ThermalContact& contact)
{
    return std::max(0.0, contact.force);
}

}  // namespace

double meanConductivity(const ThermalContact& contact)
{
    return 2 / (1 / contact.first.conductivity + 1 / contact.second.conductivity);
}

double effectiveModulus(const ThermalContact& contact)
{
    return 1 / (compliance(contact.first) + compliance(contact.second));
}

double effectiveRadius(const ThermalContact& contact)
{
    return 1 / (1 / contact.firstRadius + 1 / contact.secondRadius);
}

double hertzRadius(const ThermalContact& contact)
{
    return std::cbrt(3 * pressing(contact) * effectiveRadius(contact) / (4 * effectiveModulus(contact)));
}

double hertzHalfWidth(const ThermalContact& contact)
{
    const double loadPerLength = pressing(contact) / contact.length;
    return std::sqrt(4 * loadPerLength * effectiveRadius(contact) / (pi * effectiveModulus(contact)));
}

namespace
{

/// sqrt(k rho c) of both, one after the other [J/m^2/K/s^(1/2)].
double effusivity(const ThermalContact& contact)
{
    const auto resistance = [](const ThermalMaterial& m)
    { return m.capacity > 0 ? 1 / std::sqrt(m.conductivity * m.capacity) : 0; };
    const double both = resistance(contact.first) + resistance(contact.second);
    return both > 0 ? 1 / both : 0;
}

ThermalImpact impact(ThermalContact& contact, double impulse, double time, double area, double factor,
                     const ConductanceLaw& law)
{
    contact.force = impulse / time;
    return {time, law(contact) * time + factor * effusivity(contact) * area * std::sqrt(time)};
}

}  // namespace

ThermalImpact impactOfSpheres(ThermalContact contact, double mass, double impulse, const ConductanceLaw& law)
{
    const double E = effectiveModulus(contact), R = effectiveRadius(contact), v = impulse / (2 * mass);
    const double time = 2.87 * std::pow(mass * mass / (R * E * E * v), 0.2);
    const double depth = v * time / 2.943;
    return impact(contact, impulse, time, pi * R * depth, 0.871, law);
}

ThermalImpact impactOfCylinders(ThermalContact contact, double mass, double impulse, const ConductanceLaw& law)
{
    const double time = pi * std::sqrt(4 * mass / (pi * effectiveModulus(contact) * contact.length));
    contact.force = pi * impulse / (2 * time);
    const double area = 2 * hertzHalfWidth(contact) * contact.length;
    return impact(contact, impulse, time, area, 0.970, law);
}

double conductance::spheres(const ThermalContact& contact)
{
    return 2 * meanConductivity(contact) * hertzRadius(contact);
}

double conductance::strip(const ThermalContact& contact)
{
    const double b = hertzHalfWidth(contact);
    if (b == 0)
    {
        return 0;
    }
    const auto resistance = [&](const ThermalMaterial& material, double radius, double other)
    {
        const double r = std::isinf(radius) ? other : radius;
        return (std::log(2 * r / std::min(b, r)) + 0.125) / (pi * material.conductivity * contact.length);
    };
    return 1
           / (resistance(contact.first, contact.firstRadius, contact.secondRadius)
              + resistance(contact.second, contact.secondRadius, contact.firstRadius));
}

double conductance::rowOfSpheres(const ThermalContact& contact)
{
    const double diameter =
        std::isinf(contact.secondRadius) ? 2 * contact.firstRadius : contact.firstRadius + contact.secondRadius;
    const double pairs = contact.length / diameter;
    ThermalContact pair(contact);
    pair.force /= pairs;
    return pairs * spheres(pair);
}

double conductance::squarePatch(const ThermalContact& contact)
{
    return 2 * meanConductivity(contact) * std::sqrt(2 * hertzHalfWidth(contact) * contact.length);
}

double conductance::spot(const ThermalContact& contact)
{
    return 2 * meanConductivity(contact) * hertzHalfWidth(contact);
}

}  // namespace nscd
