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
