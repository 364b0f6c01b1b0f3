// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts of a ball in the cells of a mesh add up to the ball.

#include "Meshes.hpp"
#include "overlap/ball/BallMesh.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

const std::string kinds[] = {
    "aligned", "rotated", "warped", "warped rotated", "aligned tetrahedra", "rotated tetrahedra", "warped tetrahedra"};

/// Radii in units of the cells' size for h/d from 0.05 to 30.
const double radii[] = {10, 4, 1.5, 0.5, 1. / 6, 1. / 20, 1. / 60};

/// Worst of the sums' errors: volume and moment over the ball's volume, wetted area and vector over the ball's area.
double partitionError(BallMesh& ball, const Point3& centre, double r)
{
    // In long double: thousands of equal volumes, added in double, would lose more than the parts themselves
    using Sum = Eigen::Matrix<long double, 3, 1>;
    long double volume = 0, area = 0;
    Sum moment = Sum::Zero(), vector = Sum::Zero();
    for (const CellOverlap& part : ball.overlaps(centre, r))
    {
        volume += part.volume;
        area += part.wettedArea;
        moment += (part.volume * (part.centroid - centre)).cast<long double>();
        vector += part.wettedVector.cast<long double>();
    }
    const long double wholeVolume = 4 * pi / 3 * r * r * r, wholeArea = 4 * pi * r * r;
    return static_cast<double>(std::max({std::abs(volume / wholeVolume - 1), moment.norm() / (wholeVolume * r),
                                         std::abs(area / wholeArea - 1), vector.norm() / wholeArea}));
}

}  // namespace

TEST(BallPartition, HoldsInGeneralPosition)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-0.5, 0.5);
    for (const std::string& kind : kinds)
    {
        for (const double r : radii)
        {
            const PolyhedralMesh mesh = blockOfKind(kind, 2 * static_cast<int>(r + 2.5), {0, 0, 0}).mesh();
            BallMesh ball(mesh);
            double worst = 0;
            for (int k = 0; k < (r > 2 ? 10 : 200); ++k)
            {
                worst = std::max(worst, partitionError(ball, {unit(random), unit(random), unit(random)}, r));
            }
            EXPECT_LE(worst, 1e-14) << kind << ", radius " << r;
        }
    }
}

TEST(BallPartition, HoldsWhereVerticesEdgesAndFacesMeetCentreAndSphere)
{
    for (const std::string& kind : kinds)
    {
        for (const double r : radii)
        {
            if (r > 5) continue;
            const PolyhedralMesh mesh = blockOfKind(kind, 2 * static_cast<int>(2 * r + 3), {0, 0, 0}).mesh();
            BallMesh ball(mesh);
            const Point3 inFirstOctant =
                kind.find("rotated") == std::string::npos ? Point3(0.6, 0.5, 0.3) : Point3(0.1, 0.1, 0.1);
            BallMesh probe(mesh);
            const std::size_t middle = probe.overlaps(inFirstOctant, 1e-3)[0].cell;
            const Point3 vertex = mesh.cellVertex(middle, 0);
            const Point3 edge = mesh.cellVertex(middle, 1) - vertex;
            const Point3 other = mesh.cellVertex(middle, 2) - vertex;
            const Point3 along = edge.normalized(), normal = edge.cross(other).normalized();
            const Point3 places[] = {vertex,
                                     vertex + 0.5 * edge,
                                     vertex + 0.25 * edge + 0.25 * other,
                                     vertex + r * along,
                                     vertex + r * normal,
                                     vertex + 0.5 * edge + r * normal,
                                     vertex + 0.3 * edge + 0.3 * other - r * normal,
                                     vertex + 0.6 * r * along + 0.8 * r * normal,
                                     mesh.centroid(middle)};
            double worst = 0;
            for (const Point3& place : places)
            {
                for (const double e : {0.0, 1e-12, -1e-12, 1e-16, -1e-16})
                {
                    for (const Point3& shift : {Point3(e, 0, 0), Point3(0, e, 0), Point3(e, e, e)})
                    {
                        worst = std::max(worst, partitionError(ball, place + shift, r));
                    }
                }
            }
            EXPECT_LE(worst, 1e-14) << kind << ", radius " << r;
        }
    }
}

TEST(BallPartition, HoldsFarFromTheOrigin)
{
    // Moments are those of coordinates rounded to 1e-14, small against the cells but not against the balls
    const Point3 origin(100, -70, 130);
    for (const std::string& kind : kinds)
    {
        for (const double r : radii)
        {
            if (r > 5) continue;
            const PolyhedralMesh mesh = blockOfKind(kind, 2 * static_cast<int>(r + 2.5), origin).mesh();
            BallMesh ball(mesh);
            for (const Point3& shift : {Point3(0.1, 0.2, 0.3), Point3(0, 0, 0), Point3(0.5, 0, 0)})
            {
                long double volume = 0;
                for (const CellOverlap& part : ball.overlaps(origin + shift, r)) volume += part.volume;
                EXPECT_NEAR(static_cast<double>(volume / (4 * pi / 3 * r * r * r)), 1, 1e-14)
                    << kind << ", radius " << r;
            }
        }
    }
}
