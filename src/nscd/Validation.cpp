// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/Validation.hpp"

#include "nscd/Check.hpp"

#include <string>

namespace nscd
{

void checkMaterial(int material, const ContactTable& table, const std::string& owner)
{
    if (material < 0 || material >= table.materials())
    {
        refuse(owner, ": material ", material, " is not one of the ", table.materials(), " of the contact table");
    }
}

template <int D>
void validate(const Grains<D>& grains, const ContactTable& table)
{
    const std::size_t n = grains.size();
    const auto checkSize = [n](std::size_t size, const char* list)
    {
        if (size != n)
        {
            refuse("grains: ", n, " positions but ", size, " entries of ", list);
        }
    };
    checkSize(grains.id.size(), "id");
    checkSize(grains.velocity.size(), "velocity");
    checkSize(grains.spin.size(), "spin");
    checkSize(grains.radius.size(), "radius");
    checkSize(grains.mass.size(), "mass");
    checkSize(grains.material.size(), "material");
    checkSize(grains.temperature.size(), "temperature");
    checkSize(grains.shape.size(), "shape");
    checkSize(grains.orientation.size(), "orientation");

    for (std::size_t i = 0; i < n; ++i)
    {
        const std::string name = "grain " + std::to_string(grains.id[i]);
        const auto checkFinite = [&name](bool finite, const char* what)
        {
            if (!finite)
            {
                refuse(name, ": ", what, " is not finite");
            }
        };
        const auto checkPositive = [&](double value, const char* what, const char* unit)
        {
            checkFinite(std::isfinite(value), what);
            if (value <= 0)
            {
                refuse(name, ": ", what, " ", value, " ", unit, " is not positive");
            }
        };
        checkFinite(isFinite(grains.position[i]), "position");
        checkFinite(isFinite(grains.velocity[i]), "velocity");
        checkFinite(isFinite(grains.spin[i]), "spin");
        checkFinite(std::isfinite(grains.temperature[i]), "temperature");
        checkPositive(grains.radius[i], "radius", "m");
        checkPositive(grains.mass[i], "mass", "kg");
        checkMaterial(grains.material[i], table, name);
    }
}

void validate(const Settings& s)
{
    if (!isPositive(s.tolerance))
    {
        refuse("settings: tolerance ", s.tolerance, " m is not positive");
    }
    if (s.maxSweeps < 1)
    {
        refuse("settings: maxSweeps ", s.maxSweeps, " is less than 1");
    }
    if (!isPositive(s.maxDisplacement))
    {
        refuse("settings: maxDisplacement ", s.maxDisplacement, " is not positive");
    }
    if (s.blocks < 1 || s.blocks > 4096 || (s.blocks & (s.blocks - 1)) != 0)
    {
        refuse("settings: blocks ", s.blocks, " is not a power of two between 1 and 4096");
    }
}

void validate(const ContactTable& table)
{
    for (int a = 0; a < table.materials(); ++a)
    {
        for (int b = a; b < table.materials(); ++b)
        {
            if (!std::isfinite(table(a, b).friction) || table(a, b).friction < 0)
            {
                refuse("contact table: friction ", table(a, b).friction, " of materials ", a, " and ", b,
                       " is not a number >= 0");
            }
        }
    }
}

template void validate<2>(const Grains<2>&, const ContactTable&);
template void validate<3>(const Grains<3>&, const ContactTable&);

}  // namespace nscd
