// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Meshes.hpp"
#include "overlap/ball/BallMesh.hpp"
#include "overlap/clip/Clip.hpp"
#include "Shapes.hpp"

#include <gtest/gtest.h>

using namespace overlap;

namespace
{

struct Union
{
    double volume = 0, area = 0;
    Point3 moment = Point3::Zero(), vector = Point3::Zero();
    std::vector<double> inCell;
};

/// Members' own parts in the cells of a mesh.
Union unionInMesh(const PolyhedralMesh& mesh, const std::vector<Sphere<3>>& members)
{
    Union sum;
    sum.inCell.assign(mesh.nCells(), 0);
    BallMesh ball(mesh);
    for (std::size_t i = 0; i < members.size(); ++i)
    {
        const auto cuts = powerCell(members, i);
        if (!cuts) continue;
        for (const CellOverlap& part : ball.overlaps(members[i].centre, members[i].radius, *cuts))
        {
            sum.volume += part.volume;
            sum.area += part.wettedArea;
            sum.moment += part.volume * part.centroid;
            sum.vector += part.wettedVector;
            sum.inCell[part.cell] += part.volume;
        }
    }
    return sum;
}

double capVolume(double r, double h)
{
    return pi * (r - h) * (r - h) * (2 * r + h) / 3;
}

/// Volume of two balls less that of their lens: the caps beyond the plane of their common circle.
double unionOfTwo(double a, double b, double distance)
{
    const double place = (distance * distance + a * a - b * b) / (2 * distance);
    return 4 * pi / 3 * (a * a * a + b * b * b) - capVolume(a, place) - capVolume(b, distance - place);
}

}  // namespace

TEST(PowerCell, TwoBallsHaveTheVolumeOfTheirUnion)
{
    for (const char* kind : {"aligned", "warped rotated", "rotated tetrahedra"})
    {
        const PolyhedralMesh mesh = blockOfKind(kind, 6, {0, 0, 0}).mesh();
        for (const double a : {0.2, 0.7, 1.2})
        {
            for (const double b : {0.3, 0.7})
            {
                for (const double share : {0.3, 0.6, 0.95})
                {
                    const double distance = std::abs(a - b) + share * (a + b - std::abs(a - b));
                    const Point3 first(-0.31, 0.12, 0.23), along = Point3(1, 2, -1.5).normalized();
                    const Union sum = unionInMesh(mesh, {{first, a}, {first + distance * along, b}});
                    const double exact = unionOfTwo(a, b, distance),
                                 place = (distance * distance + a * a - b * b) / (2 * distance);
                    EXPECT_NEAR(sum.volume, exact, 2e-14 * exact) << kind;
                    EXPECT_NEAR(sum.area, 2 * pi * (a * (a + place) + b * (b + distance - place)), 1e-13);
                    EXPECT_LT(sum.vector.norm(), 1e-13);  // a closed surface
                }
            }
        }
    }
}

TEST(PowerCell, HiddenMembersCountForNothingAndEqualOnesOnce)
{
    const Sphere<3> big{{0.1, 0.2, 0.3}, 1}, hidden{{0.3, 0.2, 0.3}, 0.7}, touching{{0.6, 0.2, 0.3}, 0.5};
    EXPECT_FALSE(powerCell<3>({big, hidden}, 1));
    EXPECT_TRUE(powerCell<3>({big, hidden}, 0)->empty());
    EXPECT_FALSE(powerCell<3>({big, touching}, 1));
    EXPECT_TRUE(powerCell<3>({big, big}, 0)->empty());
    EXPECT_FALSE(powerCell<3>({big, big}, 1));
    EXPECT_FALSE(powerCell<3>({hidden, {hidden.centre, 0.8}}, 0));
    EXPECT_TRUE(powerCell<3>({big, {{5, 5, 5}, 2}}, 0)->empty());
}

TEST(PowerCell, TetrapodInCellsIsTheUnionOfItsBalls)
{
    // A cell's part of the union by counting points of a fine grid: their error falls with the surface between them
    const std::vector<Sphere<3>> tetrapod = {{{0, 0, 0}, 0.8},         {{0.6, 0.6, 0.6}, 0.5},
                                             {{0.6, -0.6, -0.6}, 0.5}, {{-0.6, 0.6, -0.6}, 0.45},
                                             {{-0.6, -0.6, 0.6}, 0.6}, {{0.1, 0.3, 0.1}, 0.7}};
    const PolyhedralMesh mesh = block(4, false, [](const Point3& p) -> Point3 { return p; }).mesh();
    const Union sum = unionInMesh(mesh, tetrapod);

    const int n = 64;
    for (std::size_t c = 0; c < mesh.nCells(); ++c)
    {
        const Point3 low = mesh.view(c).shape.low;
        int count = 0;
        for (int k = 0; k < n * n * n; ++k)
        {
            const Point3 x = low + Point3(k % n + 0.5, k / n % n + 0.5, k / (n * n) + 0.5) / n;
            const auto holds = [&](const Sphere<3>& s) { return (x - s.centre).squaredNorm() < s.radius * s.radius; };
            count += std::any_of(tetrapod.begin(), tetrapod.end(), holds);
        }
        EXPECT_NEAR(sum.inCell[c], count / std::pow(n, 3), 5e-4);
    }

    // Any other mesh sees the same body
    const Union other = unionInMesh(blockOfKind("warped rotated", 8, {0.3, 0.1, 0.2}).mesh(), tetrapod);
    EXPECT_NEAR(sum.volume, other.volume, 1e-13);
    EXPECT_NEAR(sum.area, other.area, 1e-12);
    EXPECT_LT((sum.moment - other.moment).norm(), 1e-13);
    EXPECT_LT(sum.vector.norm(), 1e-13);
}

TEST(PowerCell, DiscsHaveTheAreaOfTheirUnion)
{
    const double a = 0.9, b = 0.6, distance = 1.1, place = (distance * distance + a * a - b * b) / (2 * distance);
    const std::vector<Sphere<2>> members = {{{-0.2, 0.1}, a}, {{-0.2 + 0.6 * distance, 0.1 + 0.8 * distance}, b}};
    double area = 0;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const auto cuts = powerCell(members, i);
        for (int k = -4; k < 4; ++k)
        {
            for (int j = -4; j < 4; ++j)
            {
                Polygon cell = rectangle(k, j, k + 1, j + 1);
                for (const HalfSpace<2>& half : *cuts) cell = clipped(cell, half);
                if (cell.size() >= 3) area += discPolygon(members[i].centre, members[i].radius, cell).area;
            }
        }
    }
    const double exact =
        pi * (a * a + b * b) - a * a * segmentArea(place / a) - b * b * segmentArea((distance - place) / b);
    EXPECT_NEAR(area, exact, 3e-15);
}
