// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Scene.hpp"

#include <algorithm>
#include <numeric>

/// Flowing grains: run-out of collapsing columns (Staron & Hinch 2005, doi:10.1017/S0022112005006415) and discharge of
/// silos (Beverloo, Leniger & van de Velde 1961, doi:10.1016/0009-2509(61)85030-6).

/// Slope and intercept of the straight line through points, least squares.
inline std::pair<double, double> line(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto n = static_cast<double>(x.size());
    const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n, my = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double xx = 0, xy = 0;
    for (std::size_t k = 0; k < x.size(); ++k)
    {
        xx += (x[k] - mx) * (x[k] - mx);
        xy += (x[k] - mx) * (y[k] - my);
    }
    return {xy / xx, my - xy / xx * mx};
}

inline std::vector<double> logarithms(std::vector<double> values)
{
    std::transform(values.begin(), values.end(), values.begin(), [](double v) { return std::log(v); });
    return values;
}

/// Discs or spheres of 0.8 to 1 m radius and unit density on a lattice between walls that stand at 0 and 'width'.
template <int D>
Scene<D> filled(const nscd::Vector<D>& width, std::size_t count, double friction)
{
    Scene<D> scene(friction);
    nscd::Random random(11);
    const auto across = [&](int d) { return static_cast<std::size_t>(width[d] / 2.1); };
    for (std::size_t k = 0; k < count; ++k)
    {
        nscd::Vector<D> x;
        std::size_t rest = k;
        for (int d = 0; d + 1 < D; ++d)
        {
            x[d] = (static_cast<double>(rest % across(d)) + 0.5) * width[d] / static_cast<double>(across(d)) +
                   random.uniform(-0.04, 0.04);
            rest /= across(d);
        }
        x[D - 1] = 1.05 + 2.1 * static_cast<double>(rest);
        const double r = random.uniform(0.8, 1);
        scene.add(x, nscd::Vector<D>::Zero(), r, D == 2 ? M_PI * r * r : 4.0 / 3 * M_PI * r * r * r);
    }
    scene.settings.tolerance = 1e-4;
    scene.settings.maxSweeps = 20;
    return scene;
}

/// A column of discs against a wall without friction, at rest.
inline Scene<2> column(double aspect, double width, double friction)
{
    const auto count = static_cast<std::size_t>(0.83 * aspect * width * width / (M_PI * 0.813));
    Scene<2> scene = filled<2>(nscd::Vector<2>(width, 0), count, friction);
    scene.table.set(0, 1, {0});
    scene.walls = {{{-100, 0}, {5000, 0}, 0}, {{0, -10}, {0, 2000}, 1}, {{width, -10}, {width, 2000}, 1}};
    nscd::ContactDynamics<2> dynamics = scene.dynamics();
    for (int i = 0; i < 1000; ++i)
    {
        fall<2>(dynamics, up<2>(-g), 1e-2);
    }
    scene.grains = dynamics.grains();
    scene.walls.pop_back();
    return scene;
}

/// A column's height over its width as settled, and its run-out over its width.
struct RunOut
{
    double aspect, length;

    double overStaronHinch() const { return length / (3.25 * std::pow(aspect, 0.7)); }
};

/// The column collapses when the wall at its side is gone; about 'initialWidth' [m] wide.
inline RunOut collapse(double aspect, double initialWidth, double friction)
{
    const Scene<2> scene = column(aspect, initialWidth, friction);
    double width = 0, height = 0;
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        width = std::max(width, scene.grains.position[i].x() + scene.grains.radius[i]);
        height = std::max(height, scene.grains.position[i].y() + scene.grains.radius[i]);
    }
    nscd::ContactDynamics<2> dynamics = scene.dynamics();
    const double fallTime = std::sqrt(2 * height / g);
    const double dt = std::min(2e-2, 0.7 / std::sqrt(2 * g * height));
    for (double time = 0; time < 4 * fallTime; time += dt)
    {
        fall<2>(dynamics, up<2>(-g), dt);
    }
    // the deposit ends where the next grain on the ground does not touch any more
    std::vector<std::pair<double, double>> ground;
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const nscd::Vector<2>& x = dynamics.grains().position[i];
        if (x.y() < 4)
        {
            ground.emplace_back(x.x() - scene.grains.radius[i], x.x() + scene.grains.radius[i]);
        }
    }
    std::sort(ground.begin(), ground.end());
    double end = width;
    for (const auto& [left, right] : ground)
    {
        end = left < end + 1 ? std::max(end, right) : end;
    }
    return {height / width, (end - width) / width};
}

/// Opening and mass per second that leaves through it, of two equal parts of the mass one after the other.
struct Discharge
{
    double opening, first, second;
};

/// A silo with so many grains over a slot or a square hole, of which two parts run out after the first 5 %; those that
/// have left are taken away.
template <int D>
Discharge discharge(double opening, double width, std::size_t count, double part = 0.1)
{
    nscd::Vector<D> side = nscd::Vector<D>::Constant(width);
    Scene<D> scene = filled<D>(side, count, 0.5);
    const double a = 0.5 * (width - opening), b = 0.5 * (width + opening);
    if constexpr (D == 2)
    {
        scene.walls = {{{0, -10}, {0, 3000}, 1}, {{width, -10}, {width, 3000}, 1}, {{-1, 0}, {a, 0}, 1},
                       {{b, 0}, {width + 1, 0}, 1}, {{-1, -0.5}, {width + 1, -0.5}, 1}};
    }
    else
    {
        const auto floor = [&](double x0, double y0, double x1, double y1, double z)
        {
            scene.walls.push_back(nscd::Triangle{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, 1});
            scene.walls.push_back(nscd::Triangle{{x0, y0, z}, {x1, y1, z}, {x0, y1, z}, 1});
        };
        for (int axis = 0; axis < 2; ++axis)
        {
            scene.walls.push_back(nscd::Plane{nscd::Vector<3>::Zero(), nscd::Vector<3>::Unit(axis), 1});
            scene.walls.push_back(nscd::Plane{side, -nscd::Vector<3>::Unit(axis), 1});
        }
        floor(-1, -1, width + 1, a, 0);
        floor(-1, b, width + 1, width + 1, 0);
        floor(-1, a, a, b, 0);
        floor(b, a, width + 1, b, 0);
        scene.walls.push_back(nscd::Plane{{0, 0, -0.5}, {0, 0, 1}, 1});
    }
    nscd::ContactDynamics<D> closed = scene.dynamics();
    const double dt = 1e-2;
    for (int i = 0; i < 1000; ++i)
    {
        fall<D>(closed, up<D>(-g), dt);
    }
    scene.grains = closed.grains();
    scene.walls.pop_back();

    nscd::ContactDynamics<D> dynamics = scene.dynamics();
    const double all = std::accumulate(scene.grains.mass.begin(), scene.grains.mass.end(), 0.0);
    double time = 0, mass = all;
    std::vector<double> times;                                     // when these shares of the mass had left
    for (const double share : {0.05, 0.05 + part, 0.05 + 2 * part})
    {
        while (mass > (1 - share) * all && time < 200)
        {
            fall<D>(dynamics, up<D>(-g), dt);
            time += dt;
            std::vector<bool> gone(dynamics.grains().size());
            for (std::size_t i = 0; i < gone.size(); ++i)
            {
                gone[i] = dynamics.grains().position[i][D - 1] < -6;
            }
            if (std::count(gone.begin(), gone.end(), true) > 0)
            {
                dynamics.remove(gone);
            }
            mass = std::accumulate(dynamics.grains().mass.begin(), dynamics.grains().mass.end(), 0.0);
        }
        times.push_back(time);
    }
    return {opening, part * all / (times[1] - times[0]), part * all / (times[2] - times[1])};
}

/// Exponent of the rate in the opening less 'k' mean diameters.
inline double exponent(const std::vector<Discharge>& rates, double k)
{
    std::vector<double> x, y;
    for (const Discharge& r : rates)
    {
        x.push_back(r.opening - k * 1.8);
        y.push_back(0.5 * (r.first + r.second));
    }
    return line(logarithms(x), logarithms(y)).first;
}
