// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Cells.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

/// A box, a tetrahedron and a hexahedron with warped faces, each with a ball that cuts it.
std::vector<std::pair<Point3, Cell>> pairs()
{
    Cell warped = box({-0.4, -0.5, -0.6}, {0.7, 0.8, 0.5});
    warped.vertices[6] += Point3(0.2, -0.1, 0.15);
    warped.vertices[0] += Point3(-0.1, -0.2, 0.1);
    return {{{0.1, 0.2, 0.3}, box({-0.5, -0.4, -0.6}, {0.8, 0.9, 1})},
            {{0.9, 0.1, -0.2}, tetrahedron({-0.3, -0.2, -0.4}, {1.5, 0.1, 0}, {0.2, 1.7, 0.3}, {0.1, 0.2, 1.4})},
            {{-0.2, 0.3, 0.1}, warped}};
}

}  // namespace

TEST(BallInvariance, ScalingByAPowerOfTwoIsExact)
{
    for (const auto& [centre, cell] : pairs())
    {
        const BallOverlap a = ballCell(centre, 1, cell);
        for (const double s : {0x1p-20, 0x1p-3, 0x1p17})
        {
            const BallOverlap b =
                ballCell(s * centre, s, mapped(cell, [s = s](const Point3& p) -> Point3 { return s * p; }));
            EXPECT_EQ(b.volume, a.volume * s * s * s);
            EXPECT_EQ(b.wettedArea, a.wettedArea * s * s);
            EXPECT_EQ(b.centroid, a.centroid * s);
        }
    }
}

TEST(BallInvariance, TranslationMovesTheCentroid)
{
    for (const auto& [centre, cell] : pairs())
    {
        const BallOverlap a = ballCell(centre, 1, cell);
        for (const Point3& t : {Point3(0.7, -3.1, 2.2), Point3(100.3, 57.7, -33.3)})
        {
            const BallOverlap b =
                ballCell(centre + t, 1, mapped(cell, [t = t](const Point3& p) -> Point3 { return p + t; }));
            const double rounding = 2e-16 * t.norm();
            EXPECT_NEAR(b.volume, a.volume, 10 * rounding);
            EXPECT_NEAR(b.wettedArea, a.wettedArea, 20 * rounding);
            EXPECT_LT((b.centroid - a.centroid - t).norm(), 10 * rounding);
        }
    }
}

TEST(BallInvariance, RotationTurnsCentroidAndWettedVector)
{
    std::mt19937 random(4);
    for (const auto& [centre, cell] : pairs())
    {
        const BallOverlap a = ballCell(centre, 1, cell);
        for (int k = 0; k < 200; ++k)
        {
            const Eigen::Matrix3d turn = randomRotation(random);
            const BallOverlap b =
                ballCell(turn * centre, 1, mapped(cell, [&](const Point3& p) -> Point3 { return turn * p; }));
            EXPECT_NEAR(b.volume, a.volume, 6e-15);
            EXPECT_NEAR(b.wettedArea, a.wettedArea, 2e-14);
            EXPECT_LT((b.centroid - turn * a.centroid).norm(), 6e-15);
            EXPECT_LT((b.wettedVector - turn * a.wettedVector).norm(), 1e-14);
        }
    }
}

TEST(BallInvariance, OrderOfFacesAndFirstVertexDoNotMatter)
{
    for (auto [centre, cell] : pairs())
    {
        const BallOverlap a = ballCell(centre, 1, cell);
        for (std::size_t k = 0; k < cell.faces.size(); ++k)
        {
            std::rotate(cell.faces.begin(), cell.faces.begin() + 1, cell.faces.end());
            for (std::vector<int>& face : cell.faces) std::rotate(face.begin(), face.begin() + 1, face.end());
            const BallOverlap b = ballCell(centre, 1, cell);
            EXPECT_NEAR(b.volume, a.volume, 2e-15);
            EXPECT_LT((b.centroid - a.centroid).norm(), 3e-15);
        }
    }
}
