// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/dynamics/Validation.hpp"

#include "nscd/base/Check.hpp"

#include <limits>
#include <string>

namespace nscd
{

namespace
{

Eigen::Matrix<double, 1, 1> coefficients(const Orientation<2>& orientation)
{
    return Eigen::Matrix<double, 1, 1>(orientation.angle());
}

Eigen::Vector4d coefficients(const Orientation<3>& orientation)
{
    return orientation.coeffs();
}

}  // namespace

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
        checkFinite(isFinite(coefficients(grains.orientation[i])), "orientation");
        if (grains.shape[i] < -1 || grains.shape[i] >= static_cast<int>(grains.clusters.size()))
        {
            refuse(name, ": shape ", grains.shape[i], " is neither -1 nor one of the ", grains.clusters.size(),
                   " clusters");
        }
    }
    for (std::size_t c = 0; c < grains.clusters.size(); ++c)
    {
        const Cluster<D>& cluster = grains.clusters[c];
        bool sound = !cluster.centre.empty() && cluster.centre.size() == cluster.radius.size();
        for (std::size_t m = 0; sound && m < cluster.radius.size(); ++m)
        {
            sound = isFinite(cluster.centre[m]) && isPositive(cluster.radius[m]);
        }
        for (int d = 0; sound && d < cluster.inertia.size(); ++d)
        {
            sound = isPositive(cluster.inertia[d]);
        }
        if (!sound)
        {
            refuse("cluster ", c, ": needs members with finite centres and positive radii, and positive moments");
        }
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
    for (const double period : s.period)
    {
        if (!std::isfinite(period) || period < 0)
        {
            refuse("settings: period ", period, " m is not a number >= 0");
        }
    }
}

template <>
void validate<2>(const Settings&, const Walls<2>&)
{
}

template <>
void validate<3>(const Settings& settings, const Walls<3>& walls)
{
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        const auto* plane = std::get_if<Plane>(&walls[w]);
        for (int axis = 0; plane && axis < 3; ++axis)
        {
            if (settings.period[axis] > 0 && std::abs(plane->normal[axis]) > 1e-12 * plane->normal.norm())
            {
                refuse("settings: period ", settings.period[axis], " m, but wall ", w,
                       " is a plane across it, which has no periodic image; use triangles");
            }
        }
    }
}

template <int D>
void validate(const Settings& settings, const Grains<D>& grains)
{
    double largestRadius = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const std::vector<double> itself{1.0};
        for (const double r : grains.shape[i] < 0 ? itself : grains.clusters[grains.shape[i]].radius)
        {
            largestRadius = std::max(largestRadius, r * grains.radius[i]);
        }
    }
    for (const double period : settings.period)
    {
        if (period > 0 && period < 4 * largestRadius)
        {
            refuse("settings: period ", period, " m is less than four of the largest radii, ", largestRadius,
                   " m: a grain could touch another one twice");
        }
        // Two grains approach each other by 4 maxDisplacement radii in a sub-step: past the image that was nearest
        const double needed = (4 + 8 * settings.maxDisplacement) * largestRadius;
        if (period > 0 && settings.maxDisplacement > 0.5 && period < needed)
        {
            refuse("settings: maxDisplacement ", settings.maxDisplacement, " in a period of ", period,
                   " m: a grain could pass another one's next image unseen; at most 0.5, or a period of ", needed,
                   " m");
        }
    }
}

void validate(const ContactTable& table)
{
    for (int a = 0; a < table.materials(); ++a)
    {
        for (int b = a; b < table.materials(); ++b)
        {
            const auto check = [a, b](double value, double most, const char* name, const char* range)
            {
                if (!std::isfinite(value) || value < 0 || value > most)
                {
                    refuse("contact table: ", name, " ", value, " of materials ", a, " and ", b, " is not a number ",
                           range);
                }
            };
            constexpr double any = std::numeric_limits<double>::max();
            const ContactParameters& p = table(a, b);
            check(p.friction, any, "friction", ">= 0");
            check(p.restitution, 1, "restitution", "between 0 and 1");
            check(p.rolling, any, "rolling", ">= 0");
            check(p.cohesion, any, "cohesion", ">= 0");
            check(p.tension, any, "tension", ">= 0");
            check(p.cohesionDelay, any, "cohesionDelay", ">= 0");
            if (std::isnan(p.cohesionBelow))
            {
                check(p.cohesionBelow, any, "cohesionBelow", "a number");
            }
        }
    }
}

template void validate<2>(const Settings&, const Grains<2>&);
template void validate<3>(const Settings&, const Grains<3>&);
template void validate<2>(const Grains<2>&, const ContactTable&);
template void validate<3>(const Grains<3>&, const ContactTable&);

}  // namespace nscd
