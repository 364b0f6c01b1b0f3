// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/HeatNetwork.hpp"

#include <cstddef>
#include <numeric>

namespace nscd
{

namespace
{

/// Residual of the linear system over that of no change.
constexpr double tolerance = 1e-13;

/// Solve matrix x = b by conjugate gradients, scaled with the matrix's diagonal.  Exact arithmetic needs as many
/// iterations as there are unknowns; an ill-conditioned system gets some more.
template <class Matrix>
std::vector<double> conjugateGradients(const Matrix& matrix, const std::vector<double>& diagonal, std::vector<double> b)
{
    const std::size_t n = b.size();
    std::vector<double> x(n, 0.0), direction(n, 0.0), image(n);
    std::vector<double>& residual = b;
    const auto square = [&]
    {
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i)
        {
            sum += residual[i] * residual[i] / diagonal[i];
        }
        return sum;
    };
    double now = square(), before = now;
    const double enough = tolerance * tolerance * now;
    for (std::size_t iteration = 0; now > enough && iteration < 100 + 4 * n; ++iteration)
    {
        for (std::size_t i = 0; i < n; ++i)
        {
            direction[i] = residual[i] / diagonal[i] + now / before * direction[i];
        }
        matrix(direction, image);
        const double step = now / std::inner_product(direction.begin(), direction.end(), image.begin(), 0.0);
        for (std::size_t i = 0; i < n; ++i)
        {
            x[i] += step * direction[i];
            residual[i] -= step * image[i];
        }
        before = now;
        now = square();
    }
    return x;
}

}  // namespace

std::vector<double> HeatNetwork::change(const std::vector<double>& temperature, double dt) const
{
    std::vector<double> diagonal(capacity_), heat(capacity_.size(), 0.0);
    for (const Link& link : links_)
    {
        const double h = dt * link.conductance, flow = h * (temperature[link.j] - temperature[link.i]);
        diagonal[link.i] += h;
        diagonal[link.j] += h;
        heat[link.i] += flow;
        heat[link.j] -= flow;
    }
    for (const Outlet& outlet : outlets_)
    {
        const double h = dt * outlet.conductance;
        diagonal[outlet.i] += h;
        heat[outlet.i] += h * (outlet.temperature - temperature[outlet.i]);
    }
    const auto matrix = [&](const std::vector<double>& x, std::vector<double>& y)
    {
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            y[i] = diagonal[i] * x[i];
        }
        for (const Link& link : links_)
        {
            const double h = dt * link.conductance;
            y[link.i] -= h * x[link.j];
            y[link.j] -= h * x[link.i];
        }
    };
    return conjugateGradients(matrix, diagonal, heat);
}

/// For each body, the number of one of the bodies that it is joined to, the same for all of them.
std::vector<int> HeatNetwork::components() const
{
    std::vector<int> parent(capacity_.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&parent](int i)
    {
        while (parent[i] != i)
        {
            i = parent[i] = parent[parent[i]];
        }
        return i;
    };
    for (const Link& link : links_)
    {
        parent[root(link.i)] = root(link.j);
    }
    for (std::size_t i = 0; i < parent.size(); ++i)
    {
        parent[i] = root(static_cast<int>(i));
    }
    return parent;
}

void HeatNetwork::advance(std::vector<double>& temperature, std::vector<double>& given, double dt) const
{
    const std::vector<double> before(temperature), changes = change(temperature, dt);
    const std::vector<int> component = components();
    const std::size_t n = capacity_.size();

    // What the solution of the linear system lacks in heat, for each component: the reservoirs give it, in proportion
    // to their conductance, or, where there are none, all bodies change by the same temperature
    std::vector<double> lack(n, 0.0), outletConductance(n, 0.0), capacity(n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
    {
        temperature[i] += changes[i];
        lack[component[i]] += capacity_[i] * (temperature[i] - before[i]);
        capacity[component[i]] += capacity_[i];
    }
    for (const Outlet& outlet : outlets_)
    {
        const double heat = dt * outlet.conductance * (outlet.temperature - temperature[outlet.i]);
        given[outlet.reservoir] += heat;
        lack[component[outlet.i]] -= heat;
        outletConductance[component[outlet.i]] += outlet.conductance;
    }
    for (const Outlet& outlet : outlets_)
    {
        const int c = component[outlet.i];
        given[outlet.reservoir] += lack[c] * (outlet.conductance / outletConductance[c]);
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        const int c = component[i];
        temperature[i] -= outletConductance[c] > 0 ? 0 : lack[c] / capacity[c];
    }
}

}  // namespace nscd
