// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls in periodic boxes: where the surface is cut into periods must not be felt.

#include "Scene.hpp"
#include "Surfaces.hpp"

#include "nscd/walls/WallContact.hpp"

#include <gtest/gtest.h>

namespace
{

/// Centres of a grain of unit radius that moves over the walls under gravity.
template <int D>
nscd::Vectors<D> path(const nscd::Walls<D>& walls, const std::array<double, 3>& period, const nscd::Vector<D>& from,
                      const nscd::Vector<D>& velocity, double dt, int steps)
{
    Scene<D> scene(0.3);
    scene.walls = walls;
    scene.settings.period = period;
    scene.add(from, velocity);
    auto dynamics = scene.dynamics();
    nscd::Vectors<D> centres;
    for (int i = 0; i < steps; ++i)
    {
        fall<D>(dynamics, up<D>(-g), dt);
        centres.push_back(dynamics.grains().position[0]);
    }
    return centres;
}

/// Largest distance of two paths, and of the first from its start.
template <int D>
void expectSamePath(const nscd::Vectors<D>& one, const nscd::Vectors<D>& other, double farthest)
{
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
    {
        ASSERT_LE((one[i] - other[i]).norm(), 1e-8) << "step " << i << " at " << one[i].transpose();
    }
    EXPECT_GT((one.back() - one.front()).norm(), farthest);
}

/// Hills of period 10, ridges and hollows, one period of them from corner 'first' on.
nscd::Walls<2> hills(int first)
{
    constexpr int corners = 5;
    const double x[corners] = {0, 1.5, 4, 6, 8.5};
    const double y[corners] = {0, 0.4, -0.5, -0.3, 0.6};
    const auto corner = [&](int k) { return nscd::Vector<2>(x[k % corners] + 10 * (k / corners), y[k % corners]); };
    nscd::Walls<2> walls;
    for (int k = first; k < first + corners; ++k)
    {
        walls.push_back({corner(k), corner(k + 1), 1});
    }
    return walls;
}

/// The same in space: 3 x 3 squares of 4 m, each of two triangles, from square (i, j) on.
nscd::Walls<3> hills(int i0, int j0)
{
    const double z[3][3] = {{0, 0.5, -0.3}, {0.7, -0.2, 0.1}, {0.2, 0.6, -0.4}};
    const auto corner = [&](int i, int j) { return nscd::Vector<3>(4.0 * i, 4.0 * j, z[i % 3][j % 3]); };
    nscd::Walls<3> walls;
    for (int i = i0; i < i0 + 3; ++i)
    {
        for (int j = j0; j < j0 + 3; ++j)
        {
            walls.push_back(nscd::Triangle{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), 1});
            walls.push_back(nscd::Triangle{corner(i, j), corner(i + 1, j + 1), corner(i, j + 1), 1});
        }
    }
    return walls;
}

/// A level square of triangles.
void addSquare(nscd::Walls<3>& walls, double x, double y, double a, double b, int body = -1)
{
    const nscd::Vector<3> p(x, y, 0), q(x + a, y, 0), r(x + a, y + b, 0), s(x, y + b, 0);
    walls.push_back(nscd::Triangle{p, q, r, 1, body});
    walls.push_back(nscd::Triangle{p, r, s, 1, body});
}

}  // namespace

TEST(PeriodicWalls, OfAPlaneFloorHaveNoSeam2D)
{
    for (const double speed : {1.0, 7.0, 30.0})
    {
        const auto centres =
            path<2>({{{0, 0}, {5, 0}, 1}, {{5, 0}, {10, 0}, 1}}, {10, 0, 0}, {2, 1}, {speed, 0}, 1e-2, 1500);
        for (const nscd::Vector<2>& x : centres)
        {
            ASSERT_NEAR(x.y(), 1, 1e-9) << "at " << x.x();
        }
        EXPECT_GT(centres.back().x(), 10);
    }
}

TEST(PeriodicWalls, OfAPlaneFloorHaveNoSeam3D)
{
    // Triangles of other sizes on either side of the seam; along an axis and across a corner
    nscd::Walls<3> walls;
    addSquare(walls, 0, 0, 5, 10);
    for (int k = 0; k < 4; ++k)
    {
        addSquare(walls, 5, 2.5 * k, 5, 2.5);
    }
    const nscd::Vectors<3> velocities{{30, 0, 0}, {7, 7, 0}, {3, -20, 0}};
    for (const nscd::Vector<3>& velocity : velocities)
    {
        for (const nscd::Vector<3>& x : path<3>(walls, {10, 10, 0}, {2, 2, 1}, velocity, 1e-2, 600))
        {
            ASSERT_NEAR(x.z(), 1, 1e-9) << "at " << x.transpose();
        }
    }
}

TEST(PeriodicWalls, HillsAreTheSameWhereverTheyAreCut2D)
{
    const auto expected = path<2>(hills(0), {10, 0, 0}, {2, 2}, {9, 0}, 2e-3, 800);
    for (const int first : {1, 2, 3, 4})
    {
        SCOPED_TRACE(first);
        expectSamePath<2>(path<2>(hills(first), {10, 0, 0}, {2, 2}, {9, 0}, 2e-3, 800), expected, 8);
    }
}

TEST(PeriodicWalls, HillsAreTheSameWhereverTheyAreCut3D)
{
    const nscd::Vector<3> from(2, 2, 2.5), velocity(9, 5, 0);
    const auto expected = path<3>(hills(0, 0), {12, 12, 0}, from, velocity, 2e-3, 800);
    for (const auto& [i, j] : {std::pair(1, 0), std::pair(0, 2), std::pair(2, 1)})
    {
        SCOPED_TRACE(10 * i + j);
        expectSamePath<3>(path<3>(hills(i, j), {12, 12, 0}, from, velocity, 2e-3, 800), expected, 8);
    }
}

TEST(PeriodicWalls, OfABodyAreJoinedUntilItTurnsOutOfThePeriod)
{
    // A cell of an endless belt, and one that has turned about z by a right angle: the seam is still at x = 0, but
    // what follows there is no continuation of it
    nscd::Walls<3> walls;
    addSquare(walls, 0, 0, 10, 4, 0);
    nscd::WallContact<3> contact(walls, {10, 0, 0});
    const auto contacts = [&](const nscd::Vector<3>& centre)
    {
        int number = 0;
        for (int w = 0; w < 2; ++w)
        {
            const auto approach = contact.approach(w, centre, 1);
            number += approach && std::abs(approach->gap) < 1e-9;
        }
        return number;
    };
    EXPECT_EQ(contacts({0, 1, 1}), 1);
    const nscd::WallBody<3> initial;
    nscd::WallBody<3> raised;
    raised.position = {0, 3, 2};
    contact.place({initial}, {raised});
    EXPECT_EQ(contacts({10, 4, 3}), 1);
    nscd::WallBody<3> tilted;
    tilted.orientation = Eigen::AngleAxisd(0.3, nscd::Vector<3>::UnitY());
    contact.place({initial}, {tilted});
    // At its higher end the tilted cell has an edge, met from the side
    const nscd::Vector<3> end = tilted.orientation * nscd::Vector<3>(0, 1, 0);
    const auto approach = contact.approach(1, end + nscd::Vector<3>(-0.6, 0, 0.8), 1);
    ASSERT_TRUE(approach);
    EXPECT_NEAR(approach->gap, 0, 1e-9);
}
