// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random pairs of ball and cell against cones in extended precision.

#include "BallOracle.hpp"
#include "Cells.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

enum class Kind
{
    box,
    sheared,
    tetrahedron,
    needle,
    warped
};

/// A cell of about unit volume about the origin.
Cell randomCell(Kind kind, std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(-1, 1);
    const Cell cube = box(Point3::Constant(-0.5), Point3::Constant(0.5));
    const Eigen::Matrix3d turn = randomRotation(random);
    Eigen::Matrix3d map = Eigen::Matrix3d::Identity();

    switch (kind)
    {
    case Kind::box:
        return cube;
    case Kind::sheared:
        map << 1, 0.5 * unit(random), 0.5 * unit(random), 0, 1, 0.5 * unit(random), 0, 0, 1;
        break;
    case Kind::needle:
        map = Eigen::Vector3d(0.27, 0.27, 13.57).asDiagonal();
        break;
    case Kind::warped:
        return mapped(cube,
                      [&](const Point3& v) -> Point3
                      { return turn * (v + 0.25 * Point3(unit(random), unit(random), unit(random))); });
    case Kind::tetrahedron: {
        Point3 v[4];
        do
        {
            for (Point3& x : v) x = 1.2 * Point3(unit(random), unit(random), unit(random));
        } while (std::abs((v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0])) < 1);
        return tetrahedron(v[0], v[1], v[2], v[3]);
    }
    }
    return mapped(cube, [&](const Point3& v) -> Point3 { return turn * (map * v); });
}

/// A ball of unit radius that a random point of the cell's surface lies in.
Point3 randomCentre(const Cell& cell, std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const std::vector<int>& face = cell.faces[random() % cell.faces.size()];
    Point3 centre = Point3::Zero();
    double sum = 0;
    for (const int k : face)
    {
        const double weight = unit(random);
        centre += weight * cell.vertices[k];
        sum += weight;
    }
    return centre / sum + randomRotation(random).col(0) * unit(random);
}

}  // namespace

TEST(BallRandomPairs, AgreeWithConesInExtendedPrecision)
{
    std::mt19937 random(21);
    std::uniform_real_distribution<double> logSize(std::log(1. / 15), std::log(60.));
    double volume = 0, patch = 0, moment = 0;
    int cut = 0;

    for (int pair = 0; pair < 100000; ++pair)
    {
        const Kind kind = static_cast<Kind>(pair % 5);
        const double size = std::exp(logSize(random));
        const Cell cell = mapped(randomCell(kind, random), [&](const Point3& v) -> Point3 { return size * v; });
        const Point3 centre = randomCentre(cell, random);

        const BallOverlap x = ballCell(centre, 1, cell);
        const auto exact =
            oracle::ballPolyhedron<long double>(centre, 1, cell.vertices, cell.faces, kind == Kind::warped);
        cut += x.volume > 0 && x.wettedArea > 0;

        // Where faces are, is known to the rounding of their vertices: eps/2 of the cell's size.  The ball's surface
        // and moment of inertia per unit shift of faces, and their number, make factors of the order of ten.
        double reach = 1;
        for (const Point3& v : cell.vertices) reach = std::max(reach, (v - centre).norm());
        volume = std::max(volume, std::abs(static_cast<double>(x.volume - exact.volume)) / reach);
        patch = std::max(patch, std::abs(static_cast<double>(x.wettedArea - exact.patch)) / reach);
        const Point3 error = x.volume * (x.centroid - centre) - exact.moment.toDouble();
        moment = std::max(moment, error.norm() / reach);
    }

    const double wholeVolume = 4 * pi / 3, wholePatch = 4 * pi;
    EXPECT_LT(volume, 2e-15 * wholeVolume);
    EXPECT_LT(patch, 2e-15 * wholePatch);
    EXPECT_LT(moment, 3e-16 * wholeVolume);
    EXPECT_GT(cut, 70000);
}

TEST(BallRandomPairs, AgreeWithConesOnAndNearALattice)
{
    // Vertices, centres and radii in multiples of 1/4, moved by 0 to 1e-6: sphere and cell touch, the sphere passes
    // through vertices, the centre is on faces, edges and vertices
    std::mt19937 random(22);
    std::uniform_int_distribution<int> place(-6, 6), size(1, 6), exponent(6, 17);
    std::uniform_real_distribution<double> unit(-1, 1);
    double volume = 0, patch = 0, moment = 0;
    int pairs = 0;

    while (pairs < 20000)
    {
        const Point3 a = 0.25 * Point3(place(random), place(random), place(random));
        const double r = 0.25 * size(random);
        Cell cell = box(a, a + 0.25 * Point3(size(random), size(random), size(random)));
        if (pairs % 2)
        {
            Point3 v[4];
            for (Point3& x : v) x = 0.25 * Point3(place(random), place(random), place(random));
            if (std::abs((v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0])) < 0.01) continue;
            cell = tetrahedron(v[0], v[1], v[2], v[3]);
        }
        Point3 centre = Point3::Zero();
        if (pairs % 3) centre = std::pow(10, -exponent(random)) * Point3(unit(random), unit(random), unit(random));
        ++pairs;

        const BallOverlap x = ballCell(centre, r, cell);
        const auto exact = oracle::ballPolyhedron<long double>(centre, r, cell.vertices, cell.faces, false);
        volume = std::max(volume, std::abs(static_cast<double>(x.volume / (r * r * r) - exact.volume)));
        patch = std::max(patch, std::abs(static_cast<double>(x.wettedArea / (r * r) - exact.patch)));
        moment = std::max(moment, (x.volume * (x.centroid - centre) / std::pow(r, 4) - exact.moment.toDouble()).norm());
    }
    EXPECT_LT(volume, 1e-14);
    EXPECT_LT(patch, 3e-14);
    EXPECT_LT(moment, 3e-15);
}
