// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Conduction from a grain of unit radius in the hollow of two facets that share its load.

#include "nscd/heat/Conduction.hpp"

#include <gtest/gtest.h>

#include <cmath>

using nscd::Vector;

namespace contactPatchTest
{

namespace
{

constexpr double load = 100, infinity = std::numeric_limits<double>::infinity();
const nscd::ThermalMaterial rubber{1, 1e6, 0.3};

template <int D>
double radiusOf(double force)
{
    const nscd::ThermalContact contact{rubber, rubber, 1, infinity, force, 1};
    return D == 2 ? nscd::hertzHalfWidth(contact) : nscd::hertzRadius(contact);
}

template <int D>
double conductanceOf(double force)
{
    return nscd::defaultConductance<D>()({rubber, rubber, 1, infinity, force, 1});
}

/// Contacts as far apart as given, each in all of some sub-steps of a step of 1 s.
template <int D>
double conductance(double apart, int subSteps = 1)
{
    nscd::Grains<D> grains;
    grains.resize(1);
    grains.radius[0] = 1;
    grains.temperature[0] = 300;
    std::vector<nscd::Touching<D>> touching;
    for (int s = 0; s < subSteps; ++s)
    {
        for (const int side : {0, 1})
        {
            const Vector<D> point = (side - 0.5) * apart * Vector<D>::Unit(0);
            touching.push_back({0, ~side, point, 0.5 * load / subSteps, 1.0 / subSteps, 0});
        }
    }
    const nscd::Conduction<D> conduction({rubber}, 1);
    const nscd::HeatNetwork network = conduction.network(grains, {1.0}, touching, {{0, 400.0}, {0, 400.0}}, 1);
    double sum = 0;
    for (const nscd::HeatNetwork::Outlet& outlet : network.outlets())
    {
        sum += outlet.conductance;
    }
    return sum;
}

template <int D>
void isOneWhereTheyCoincideAndTwoWhereTheyDoNotMeet()
{
    const double together = conductanceOf<D>(load), radius = radiusOf<D>(0.5 * load);
    EXPECT_NEAR(conductance<D>(0) / together, 1, 1e-12);
    EXPECT_NEAR(conductance<D>(2 * radius) / (2 * conductanceOf<D>(0.5 * load)), 1, 1e-12);
    EXPECT_NEAR(conductance<D>(0.5 * radius, 7) / conductance<D>(0.5 * radius), 1, 1e-12);
    EXPECT_GT(conductance<D>(2 * radius), 1.3 * together);
    double last = together;
    for (double apart = 0; apart <= 2.1; apart += 0.01)
    {
        const double now = conductance<D>(apart * radius);
        EXPECT_GE(now, last * (1 - 1e-12));
        EXPECT_LE(now, last + 0.01 * together);
        last = now;
    }
}

}  // namespace

TEST(ContactPatch, OfDiscsIsOneWhereTheyCoincideAndTwoWhereTheyDoNotMeet)
{
    isOneWhereTheyCoincideAndTwoWhereTheyDoNotMeet<2>();
}

TEST(ContactPatch, OfSpheresIsOneWhereTheyCoincideAndTwoWhereTheyDoNotMeet)
{
    isOneWhereTheyCoincideAndTwoWhereTheyDoNotMeet<3>();
}

}  // namespace contactPatchTest
