// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/packing/Packing.hpp"

#include "nscd/base/Check.hpp"

#include <array>
#include <cmath>

namespace nscd
{

namespace
{

/// A lattice that would fill the box exactly must not lose its last row to round-off.
constexpr double latticeRoundOff = 1e-10;

/// Times in which a grain would fall by a radius for which it has to stay at rest.  One that tips over another of its
/// size is sixty times as fast after five.
constexpr double fallsAtRest = 5;

/// Number of centres from 'first' to 'last' in steps of 'step'.
int count(double first, double step, double last)
{
    const double steps = std::floor((last - first) / step + latticeRoundOff);
    return steps < 0 ? 0 : static_cast<int>(steps) + 1;
}

}  // namespace

template <int D>
void checkBox(const Box<D>& box)
{
    for (int d = 0; d < D; ++d)
    {
        if (!std::isfinite(box.lower[d]) || !std::isfinite(box.upper[d]) || box.lower[d] >= box.upper[d])
        {
            refuse("box: from ", box.lower[d], " to ", box.upper[d], " m along axis ", d, " is empty");
        }
    }
}

template <int D>
Vectors<D> lattice(const Box<D>& box, double radius, double spacing)
{
    checkBox<D>(box);
    checkRadius(radius);
    if (!std::isfinite(spacing) || spacing < 2 * radius * (1 - latticeRoundOff))
    {
        refuse("spacing ", spacing, " m is less than two radii of ", radius, " m");
    }
    const Vector<D> first = box.lower.array() + radius;
    std::array<int, 3> n{1, 1, 1};
    for (int d = 0; d < D; ++d)
    {
        n[d] = count(first[d], spacing, box.upper[d] - radius);
    }
    Vectors<D> centres;
    for (int k = 0; k < n[2]; ++k)
    {
        for (int j = 0; j < n[1]; ++j)
        {
            for (int i = 0; i < n[0]; ++i)
            {
                centres.push_back(first + spacing * Vector<3>(i, j, k).head<D>());
            }
        }
    }
    return centres;
}

template <int D>
Vectors<D> hexagonal(const Box<D>& box, double radius, double gap)
{
    checkBox<D>(box);
    checkRadius(radius);
    if (!std::isfinite(gap) || gap < 0)
    {
        refuse("gap ", gap, " m is negative");
    }
    const double spacing = 2 * radius + gap;
    const double rowHeight = spacing * std::sqrt(3.0) / 2;
    const double layerHeight = spacing * std::sqrt(2.0 / 3);
    const Vector<D> first = box.lower.array() + radius;
    const Vector<D> last = box.upper.array() - radius;
    int layers = 1;
    if constexpr (D == 3)
    {
        layers = count(first[2], layerHeight, last[2]);
    }

    Vectors<D> centres;
    for (int k = 0; k < layers; ++k)
    {
        const int stacking = k % 3;   // ABC: each layer sits in the hollows of the one below
        const double y0 = first[1] + stacking * rowHeight / 3 * 2;
        const double yLow = y0 - std::floor((y0 - first[1]) / rowHeight + latticeRoundOff) * rowHeight;
        const int rowsBelow = static_cast<int>(std::lround((y0 - yLow) / rowHeight));
        const int rows = count(yLow, rowHeight, last[1]);
        for (int j = 0; j < rows; ++j)
        {
            const double shift = ((j - rowsBelow) & 1) ? 0.5 * spacing : 0.0;
            const double x0 = first[0] + shift;
            const int columns = count(x0, spacing, last[0]);
            for (int i = 0; i < columns; ++i)
            {
                Vector<D> x;
                x[0] = x0 + i * spacing;
                x[1] = yLow + j * rowHeight;
                if constexpr (D == 3)
                {
                    x[2] = first[2] + k * layerHeight;
                }
                centres.push_back(x);
            }
        }
    }
    return centres;
}

template <int D>
Settled<D> settle(ContactDynamics<D> dynamics, const Vector<D>& gravity, double dt, double atRest, double maxTime,
                  const std::function<void(double, double, const Grains<D>&)>& report)
{
    if (!isPositive(atRest))
    {
        refuse("velocity at rest ", atRest, " m/s is not positive");
    }
    if (!isPositive(maxTime))
    {
        refuse("longest time ", maxTime, " s is not positive");
    }
    if (!isPositive(dt))
    {
        refuse("time step ", dt, " s is not positive");
    }
    const std::size_t n = dynamics.grains().size();
    Vectors<D> weight(n);
    double meanRadius = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        weight[i] = dynamics.grains().mass[i] * gravity;
        meanRadius += dynamics.grains().radius[i] / static_cast<double>(n);
    }
    const Spins<D> noTorque(n, Spin<D>::Zero());
    const double g = gravity.norm();
    const double rest = g > 0 ? fallsAtRest * std::sqrt(2 * meanRadius / g) : 0;

    Settled<D> settled;
    settled.atRest = n == 0;
    double moved = 0;   // when a grain was last faster than at rest
    for (std::int64_t step = 1; settled.time < maxTime && !settled.atRest; ++step)
    {
        settled.maxVelocity = dynamics.step(weight, noTorque, dt).maxVelocity;
        settled.time = static_cast<double>(step) * dt;
        if (report)
        {
            report(settled.time, settled.maxVelocity, dynamics.grains());
        }
        moved = settled.maxVelocity > atRest ? settled.time : moved;
        settled.atRest = settled.maxVelocity <= atRest && settled.time - moved >= rest;
    }
    settled.grains = dynamics.grains();
    return settled;
}

template void checkBox<2>(const Box<2>&);
template void checkBox<3>(const Box<3>&);
template Vectors<2> lattice<2>(const Box<2>&, double, double);
template Vectors<3> lattice<3>(const Box<3>&, double, double);
template Vectors<2> hexagonal<2>(const Box<2>&, double, double);
template Vectors<3> hexagonal<3>(const Box<3>&, double, double);
template Settled<2> settle<2>(ContactDynamics<2>, const Vector<2>&, double, double, double,
                              const std::function<void(double, double, const Grains<2>&)>&);
template Settled<3> settle<3>(ContactDynamics<3>, const Vector<3>&, double, double, double,
                              const std::function<void(double, double, const Grains<3>&)>&);

}  // namespace nscd
