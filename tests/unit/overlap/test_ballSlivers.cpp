// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Overlaps much smaller than ball and cell, against cones in quadruple precision.

#include "BallOracle.hpp"
#include "Cells.hpp"

#include <gtest/gtest.h>
#include <limits>

using namespace overlap;

namespace
{

struct Errors
{
    double volume = 0, centroid = 0;  ///< in units of kappa eps
    double patch = 0;                 ///< in units of the radius squared
    int count = 0;

    /// kappa: relative change of the volume per shift of every bounding surface by eps times the largest distance
    /// from the ball's centre, which is what rounding the coordinates can do.
    void compare(const Point3& centre, const Cell& cell)
    {
        const BallOverlap x = ballCell(centre, 1, cell);
        const auto exact = oracle::ballPolyhedron<oracle::Quad>(centre, 1, cell.vertices, cell.faces, false);
        if (!(exact.volume > 0 && exact.patch > 0)) return;  // covered
        const double whole = static_cast<double>(exact.volume);
        double reach = 1;
        for (const Point3& v : cell.vertices) reach = std::max(reach, (v - centre).norm());
        const double kappa = reach * static_cast<double>(exact.area + exact.patch) / whole;
        const double unit = kappa * std::numeric_limits<double>::epsilon();
        if (unit > 0.01) return;

        ++count;
        volume = std::max(volume, std::abs(static_cast<double>(x.volume - exact.volume)) / (whole * unit));
        const Point3 arm = exact.moment.toDouble() / whole;
        centroid = std::max(centroid, (x.centroid - centre - arm).norm() / unit);
        patch = std::max(patch, std::abs(static_cast<double>(x.wettedArea - exact.patch)));
    }
};

}  // namespace

TEST(BallSlivers, CornersEdgesAndFacesThatDipIntoTheBallKeepTheirRelativeAccuracy)
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> unit(0, 1);
    Errors errors;

    for (int pair = 0; pair < 1000; ++pair)
    {
        const double size = std::pow(10, 2 * unit(random) - 1);
        Cell cell = box({0, 0, 0}, size * Point3(1, 0.3 + unit(random), 0.3 + unit(random)));
        if (pair % 2)
        {
            const Eigen::Matrix3d turn = size * randomRotation(random);
            cell = tetrahedron(turn * Point3(0, 0, 0), turn * Point3(1, 0.2, 0.1), turn * Point3(0.3, 1, -0.2),
                               turn * Point3(0.1, 0.2, 1));
        }

        // Corner 0, a point on the edge to corner 1, a point of the face of 0, 1 and 2
        const Point3 a = cell.vertices[0], b = cell.vertices[1], c = cell.vertices[2];
        const double s = 0.3 + 0.4 * unit(random), t = 0.2 + 0.1 * unit(random);
        Point3 middle = Point3::Zero();
        for (const Point3& v : cell.vertices) middle += v / cell.vertices.size();
        Point3 place = a, outward = a - middle;
        if (pair % 3 == 1)
        {
            place += s * (b - a);
            outward -= outward.dot(b - a) / (b - a).squaredNorm() * (b - a);
        }
        if (pair % 3 == 2)
        {
            place += t * (b - a) + t * (c - a);
            const Point3 normal = (b - a).cross(c - a);
            outward = normal.dot(outward) * normal;
        }
        const double depth = std::pow(10, -5 * unit(random) - 1);
        errors.compare(place + (1 - depth) * outward.normalized(), cell);
    }

    EXPECT_LT(errors.volume, 20);
    EXPECT_LT(errors.centroid, 20);
    EXPECT_LT(errors.patch, 4e-15);
    EXPECT_GT(errors.count, 900);
}

TEST(BallSlivers, SmallCellsAtTheSphereKeepTheirRelativeAccuracy)
{
    std::mt19937 random(32);
    std::uniform_real_distribution<double> unit(-1, 1);
    Errors errors;

    for (int pair = 0; pair < 1000; ++pair)
    {
        const double size = std::pow(10, -1.5 + 1.5 * unit(random));
        const Point3 a = randomRotation(random).col(0);
        const Eigen::Matrix3d turn = size * randomRotation(random);
        const Point3 shift = 0.6 * size * Point3(unit(random), unit(random), unit(random));
        const Cell cell =
            tetrahedron(a + shift + turn * Point3(-0.4, -0.4, -0.4), a + shift + turn * Point3(1, 0.2, 0.1),
                        a + shift + turn * Point3(0.3, 1, -0.2), a + shift + turn * Point3(0.1, 0.2, 1));
        if (ballCell(Point3::Zero(), 1, cell).wettedArea > 0) errors.compare(Point3::Zero(), cell);
    }

    EXPECT_LT(errors.volume, 20);
    EXPECT_LT(errors.centroid, 20);
    EXPECT_LT(errors.patch, 4e-15);
    EXPECT_GT(errors.count, 500);
}
