// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Shapes of clusters: volume, centre of mass and principal moments of unions.

#include "Messages.hpp"

#include "nscd/base/Random.hpp"
#include "nscd/shape/Cluster.hpp"
#include "nscd/shape/UnionMoments.hpp"

#include <gtest/gtest.h>

#include <numeric>

using nscd::Orientation;
using nscd::PlacedCluster;
using nscd::Spin;
using nscd::Vector;
using nscd::Vectors;

namespace
{

template <int D>
const double ballVolume = D == 2 ? M_PI : 4 * M_PI / 3;

/// Simpson's rule; the integrands are smooth.
template <class F>
double integral(double from, double to, F&& f)
{
    constexpr int n = 2000;
    const double h = (to - from) / n;
    double sum = f(from) + f(to);
    for (int i = 1; i < n; ++i)
    {
        sum += (i % 2 ? 4 : 2) * f(from + i * h);
    }
    return sum * h / 3;
}

/// Rotation by an angle that favours no axis.
template <int D>
Orientation<D> turned(double angle)
{
    if constexpr (D == 2)
    {
        return Orientation<2>(angle);
    }
    else
    {
        return Orientation<3>(Eigen::AngleAxisd(angle, Vector<3>(1, 2, -1.5).normalized()));
    }
}

template <int D>
struct Members
{
    Vectors<D> centres;
    std::vector<double> radii;
};

/// Five members that overlap, in a body without symmetry.
template <int D>
Members<D> lump()
{
    nscd::Random random(3);
    Members<D> members;
    for (int i = 0; i < 5; ++i)
    {
        Vector<D> x;
        for (int d = 0; d < D; ++d)
        {
            x[d] = random.uniform(-1, 1) * (d == 0 ? 1.5 : 0.8);
        }
        members.centres.push_back(x);
        members.radii.push_back(random.uniform(0.6, 1));
    }
    return members;
}

template <int D>
void expectSingleIsTheSolidBall()
{
    double size = 0;
    const auto ball = nscd::makeCluster<D>({Vector<D>::Constant(7)}, {0.02}, &size);
    EXPECT_DOUBLE_EQ(size, 0.02);
    ASSERT_EQ(ball.centre.size(), 1u);
    EXPECT_NEAR(ball.centre[0].norm(), 0, 1e-15);
    EXPECT_EQ(ball.radius[0], 1);
    EXPECT_NEAR(ball.volume, ballVolume<D>, 1e-12);
    EXPECT_NEAR((ball.inertia - Spin<D>::Constant(nscd::inertiaFactor<D>)).norm(), 0, 1e-12);
}

/// The point of the shape in the frame of the members.
template <int D>
Vector<D> placed(const PlacedCluster<D>& cluster, std::size_t member)
{
    const auto axes = cluster.orientation.toRotationMatrix();
    return cluster.position + axes * (cluster.size * cluster.shape.centre[member]);
}

template <int D>
void expectSameShapeWhereverItLies()
{
    const Members<D> members = lump<D>();
    const auto original = nscd::placedCluster<D>(members.centres, members.radii);
    for (const double angle : {0.0, 0.1, 0.3, 1.0, 2.0, 3.0})
    {
        Vectors<D> moved;
        for (const Vector<D>& x : members.centres)
        {
            moved.push_back(1e-3 * (turned<D>(angle) * x) + Vector<D>::Constant(angle));
        }
        std::vector<double> radii = members.radii;
        for (double& r : radii)
        {
            r *= 1e-3;
        }
        const auto cluster = nscd::placedCluster<D>(moved, radii);
        EXPECT_NEAR(cluster.size, 1e-3 * original.size, 1e-10 * original.size);
        EXPECT_NEAR(cluster.shape.volume / original.shape.volume, 1, 1e-7);

        // Axes may come in another order
        Spin<D> a = cluster.shape.inertia, b = original.shape.inertia;
        std::sort(a.data(), a.data() + a.size());
        std::sort(b.data(), b.data() + b.size());
        EXPECT_NEAR((a - b).norm(), 0, 1e-7);
        for (std::size_t i = 0; i < moved.size(); ++i)
        {
            EXPECT_NEAR((placed(cluster, i) - moved[i]).norm(), 0, 1e-12);
        }
    }
}

template <int D>
void expectBodyFrameOfTheShape()
{
    const auto shape = nscd::makeCluster<D>(lump<D>().centres, lump<D>().radii);
    const nscd::Moments<D> moments = nscd::unionMoments<D>(shape.centre, shape.radius);
    EXPECT_NEAR(moments.volume, shape.volume, 1e-7);
    EXPECT_NEAR(moments.first.norm(), 0, 1e-7);
    const Eigen::Matrix<double, D, D> diagonal = moments.second.diagonal().asDiagonal();
    EXPECT_NEAR((moments.second - diagonal).norm(), 0, 1e-7);
    double reach = 0;
    for (std::size_t i = 0; i < shape.centre.size(); ++i)
    {
        reach = std::max(reach, shape.centre[i].norm() + shape.radius[i]);
    }
    EXPECT_NEAR(reach, 1, 1e-12);
}

}  // namespace

TEST(Cluster, OfOneMemberIsASolidDiscOrSphere)
{
    expectSingleIsTheSolidBall<2>();
    expectSingleIsTheSolidBall<3>();
}

TEST(Cluster, OfDisjointMembersObeysTheParallelAxisTheorem)
{
    // Radii 1 and 2, centres 4 apart; size is from the centre of mass to the far side of the first
    double size = 0;
    const auto discs = nscd::makeCluster<2>({{0, 1}, {0, 5}}, {1, 2}, &size);
    EXPECT_NEAR(size, 3.2 + 1, 1e-14);
    EXPECT_NEAR(discs.volume * size * size, 5 * M_PI, 1e-12);
    const double polar = (1 * (0.5 + 3.2 * 3.2) + 4 * (0.5 * 4 + 0.8 * 0.8)) / 5;
    EXPECT_NEAR(discs.inertia[0] * size * size, polar, 1e-12);

    const double c1 = 4.0 * 8 / 9, c2 = 4.0 / 9;
    const auto spheres = nscd::makeCluster<3>({{1, 0, 2}, {1, 4, 2}}, {1, 2}, &size);
    EXPECT_NEAR(size, c1 + 1, 1e-9);
    const double along = (1 * 0.4 + 8 * 0.4 * 4) / 9;
    const double across = along + (c1 * c1 + 8 * c2 * c2) / 9;
    EXPECT_NEAR((spheres.inertia * size * size - Vector<3>(across, along, across)).norm(), 0, 1e-8);
}

TEST(Cluster, OfTwoOverlappingDiscsCountsTheLensOnce)
{
    const double r = 1.3;
    for (const double d : {1e-3, 0.1, 1.0, 2.5, 2.5999})
    {
        double size = 0;
        const auto pair = nscd::makeCluster<2>({{-d / 2, 0}, {d / 2, 0}}, {r, r}, &size);
        const double lens = 2 * r * r * std::acos(d / 2 / r) - d / 2 * std::sqrt(4 * r * r - d * d);
        EXPECT_NEAR(size, r + d / 2, 1e-14);
        EXPECT_NEAR(pair.volume * size * size, 2 * M_PI * r * r - lens, 1e-12);

        // Twice the part x > 0, x = d/2 - r cos(phi), in strips of half height r sin(phi)
        const double polar = 2
                             * integral(std::acos(d / 2 / r), M_PI,
                                        [&](double phi)
                                        {
                                            const double x = d / 2 - r * std::cos(phi), h = r * std::sin(phi);
                                            return (2 * x * x * h + 2 * h * h * h / 3) * r * std::sin(phi);
                                        });
        EXPECT_NEAR(pair.inertia[0] * pair.volume * std::pow(size, 4), polar, 1e-11);
    }
}

TEST(Cluster, OfTwoOverlappingSpheresCountsTheLensOnce)
{
    const double r = 1.3;
    for (const double d : {1e-3, 0.1, 1.0, 2.5, 2.5999})
    {
        for (const double tilt : {0.0, 0.4, 1.5707, 2.5})
        {
            const Vector<3> half(d / 2 * std::cos(tilt), 0, d / 2 * std::sin(tilt));
            double size = 0;
            const auto pair = nscd::makeCluster<3>({half, -half}, {r, r}, &size);
            const double lens = M_PI * (4 * r + d) * std::pow(2 * r - d, 2) / 12;
            EXPECT_NEAR(pair.volume * std::pow(size, 3), 8 * M_PI / 3 * r * r * r - lens, 1e-7);  // the rule's 1e-8

            const auto square = [&](double x) { return r * r - std::pow(x - d / 2, 2); };  // of a slice's radius
            const auto moment = [&](auto&& f) { return 2 * M_PI * integral(0, r + d / 2, f); };
            const double along = moment([&](double x) { return square(x) * square(x) / 2; });
            const double across = along / 2 + moment([&](double x) { return square(x) * x * x; });
            Spin<3> inertia = pair.inertia * pair.volume * std::pow(size, 5);
            std::sort(inertia.data(), inertia.data() + 3);
            EXPECT_NEAR((inertia - Vector<3>(along, across, across)).norm(), 0, 1e-8 * across);
        }
    }
}

TEST(Cluster, OfSpheresEqualsSumsOverLines)
{
    // Exact unions along 1000 x 1000 vertical lines: the error of the midpoint rule at the rim is about 1e-5
    const Members<3> m = lump<3>();
    constexpr int n = 1000;
    const double h = 6.0 / n;
    double volume = 0, squares = 0;
    for (int line = 0; line < n * n; ++line)
    {
        const Vector<2> x(-3 + h * (line % n + 0.5), -3 + h * (line / n + 0.5));
        std::vector<std::pair<double, double>> spans;
        for (std::size_t i = 0; i < m.radii.size(); ++i)
        {
            const double square = m.radii[i] * m.radii[i] - (x - m.centres[i].head<2>()).squaredNorm();
            if (square > 0)
            {
                spans.push_back({m.centres[i].z() - std::sqrt(square), m.centres[i].z() + std::sqrt(square)});
            }
        }
        std::sort(spans.begin(), spans.end());
        double reached = -10;
        for (const auto& [low, high] : spans)
        {
            const double from = std::max(low, reached), to = std::max(from, high);
            volume += h * h * (to - from);
            squares += h * h * ((to - from) * x.squaredNorm() + (to * to * to - from * from * from) / 3);
            reached = std::max(reached, high);
        }
    }
    const nscd::Moments<3> moments = nscd::unionMoments<3>(m.centres, m.radii);
    EXPECT_NEAR(moments.volume / volume, 1, 3e-5);
    EXPECT_NEAR(moments.second.trace() / squares, 1, 3e-5);
}

TEST(Cluster, IsTheSameWhereverItLies)
{
    expectSameShapeWhereverItLies<2>();
    expectSameShapeWhereverItLies<3>();
}

TEST(Cluster, LiesInItsPrincipalFrame)
{
    expectBodyFrameOfTheShape<2>();
    expectBodyFrameOfTheShape<3>();
}

TEST(Cluster, IsNotChangedByMembersWithinOthers)
{
    const Members<3> m = lump<3>();
    Vectors<3> centres = m.centres;
    std::vector<double> radii = m.radii;
    centres.insert(centres.end(), m.centres.begin(), m.centres.end());
    radii.insert(radii.end(), m.radii.begin(), m.radii.end());
    centres.push_back(m.centres[1] + Vector<3>(0.1, 0, 0));
    radii.push_back(m.radii[1] - 0.2);

    const auto once = nscd::makeCluster<3>(m.centres, m.radii), more = nscd::makeCluster<3>(centres, radii);
    EXPECT_EQ(more.centre.size(), m.centres.size());
    EXPECT_EQ(more.volume, once.volume);
    EXPECT_EQ(more.inertia, once.inertia);

    const auto all = nscd::unionMoments<3>(centres, radii), few = nscd::unionMoments<3>(m.centres, m.radii);
    EXPECT_NEAR(all.volume / few.volume, 1, 1e-8);
    EXPECT_NEAR((all.second - few.second).norm() / few.second.norm(), 0, 1e-8);
}

TEST(Cluster, KeepsTheAxesOfASymmetricBody)
{
    // A cross of equal arms, and a tetrahedron: no direction is special; a rod: one is
    const auto cross = nscd::placedCluster<2>({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {1, 1, 1, 1});
    EXPECT_EQ(cross.orientation.angle(), 0);
    const auto tetrahedron =
        nscd::placedCluster<3>({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {1.5, 1.5, 1.5, 1.5});
    EXPECT_EQ(tetrahedron.orientation.angularDistance(Orientation<3>::Identity()), 0);
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto rod = nscd::placedCluster<3>({Vector<3>::Zero(), Vector<3>::Unit(axis)}, {1, 1});
        EXPECT_NEAR(rod.orientation.angularDistance(Orientation<3>::Identity()), 0, 1e-7);
        EXPECT_NEAR(std::abs(rod.shape.centre[0][axis]), 1.0 / 3, 1e-9);
    }
    // A rod inclined by 0.3 from y keeps y as its long axis, a flat body inclined by 0.2 its directions
    const auto inclined = nscd::placedCluster<2>({{0, 0}, {std::sin(0.3), -std::cos(0.3)}}, {1, 1});
    EXPECT_NEAR(inclined.orientation.angle(), 0.3, 1e-12);
    const Eigen::Matrix3d tilt = turned<3>(0.2).toRotationMatrix();
    const auto flat =
        nscd::placedCluster<3>({2 * tilt.col(1), -2 * tilt.col(1), tilt.col(2), -tilt.col(2)}, {1.5, 1.5, 1.5, 1.5});
    EXPECT_NEAR((flat.orientation.toRotationMatrix() - tilt).norm(), 0, 1e-7);
}

TEST(Rod, IsAStadiumInTheLimitOfManyMembers)
{
    // The area that is missing between neighbours falls as the square of their distance
    const double ratio = 3, width = 2 / ratio, straight = 2 - width, r = width / 2;
    const double area = straight * width + M_PI * r * r;
    const double halfDisc = M_PI * r * r / 2, lever = 4 * r / (3 * M_PI);
    const double ends = 2 * halfDisc * (r * r / 2 - lever * lever + std::pow(straight / 2 + lever, 2));
    const double polar = straight * width * (straight * straight + width * width) / 12 + ends;
    double before = 0;
    for (const int members : {25, 49, 97})
    {
        const auto rod = nscd::makeRod<2>(members, ratio);
        const double missing = 1 - rod.volume / area;
        EXPECT_GT(missing, 0);
        if (before > 0)
        {
            EXPECT_NEAR(before / missing, 4, 0.05);
            EXPECT_NEAR(rod.inertia[0] * rod.volume / polar, 1, 2 * missing);
        }
        before = missing;
    }
}

TEST(Rod, HasTheRatioOfLengthToWidth)
{
    for (const auto& [members, ratio] : {std::pair{3, 2.5}, {2, 2.0}, {5, 1.1}})
    {
        const auto rod = nscd::makeRod<3>(members, ratio);
        ASSERT_EQ(rod.centre.size(), static_cast<std::size_t>(members));
        EXPECT_NEAR(1 / rod.radius[0], ratio, 1e-9);
        EXPECT_NEAR(std::abs(rod.centre[0].x()) + rod.radius[0], 1, 1e-9);
        EXPECT_LT(rod.inertia[0], rod.inertia[1]);
    }
    EXPECT_EQ(nscd::makeRod<2>(4, 1).centre.size(), 1u);
    EXPECT_NEAR(nscd::makeRod<2>(1, 1).inertia[0], 0.5, 1e-12);
}

TEST(Cluster, RefusesSenselessInput)
{
    const auto cluster = [](const Vectors<2>& x, const std::vector<double>& r)
    { return invalid([&] { nscd::makeCluster<2>(x, r); }); };
    EXPECT_EQ(cluster({}, {}), "cluster: no members");
    EXPECT_EQ(cluster({{0, 0}}, {1, 1}), "cluster: 1 centres but 2 radii");
    EXPECT_EQ(cluster({{0, 0}, {0, 1}}, {1, 0}), "cluster: radius 0 m of member 1 is not positive");
    EXPECT_EQ(cluster({{0, std::nan("")}}, {1}), "cluster: the centre of member 0 is not finite");
    EXPECT_EQ(invalid([] { nscd::makeRod<2>(0, 1); }), "rod: 0 members are less than 1");
    EXPECT_EQ(invalid([] { nscd::makeRod<2>(2, 3); }),
              "rod: aspect ratio 3 is not between 1 and its number of members, 2");
    EXPECT_EQ(invalid([] { nscd::makeRod<2>(2, 0.9); }),
              "rod: aspect ratio 0.9 is not between 1 and its number of members, 2");
}
