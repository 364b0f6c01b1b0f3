// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Spheres that roll over, rest in, hit and stay inside surfaces of triangles.

#include "Scene.hpp"
#include "Surfaces.hpp"

#include "nscd/walls/WallContact.hpp"

#include <gtest/gtest.h>

namespace triangleScenes
{

constexpr double dt = 1e-2;

/// A sphere that is pushed along a floor at an angle to its pieces.
Scene<3> rolling(double friction, const Surface& floor)
{
    Scene<3> scene(friction);
    scene.walls = floor;
    scene.add({-4, -3, 1}, {2, 0.5, 0});
    return scene;
}

Surface roughlyCutFloor()
{
    Surface floor;
    addParallelogram(floor, {-6, -6, 0}, {14, 0, 0}, {0, 14, 0}, 40);
    return floor;
}

/// A cube of side 'size' around the origin.
Surface centredBox(double size, int body = -1)
{
    Surface box = boxSurface(Point::Constant(size), 2);
    const Point shift = Point::Constant(-size / 2);
    for (auto& wall : box)
    {
        auto& triangle = std::get<nscd::Triangle>(wall);
        triangle = {triangle.a + shift, triangle.b + shift, triangle.c + shift, 1, body};
    }
    return box;
}

/// Deepest penetration of a wall in fractions of the radius.
double wallPenetration(const nscd::ContactDynamics<3>& dynamics, const nscd::WallContact<3>& walls)
{
    double deepest = 0;
    for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
    {
        const Point& x = dynamics.grains().position[i];
        const double radius = dynamics.grains().radius[i];
        walls.forNear(x, radius, [&](int w) { deepest = std::max(deepest, 1 - walls.distance(w, x) / radius); });
    }
    return deepest;
}

/// Spheres inside a surface around the origin, driven by forces of up to 'strength' times their weight at random.
/// Returns the deepest penetration of a wall in any step, in fractions of the radius.
double agitate(const Surface& surface, double strength)
{
    Scene<3> scene(0.3);
    scene.walls = surface;
    nscd::Random random(8);
    for (int i = 0; i < 27; ++i)
    {
        const Point cell(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        scene.add(0.45 * cell, Point::Zero(), random.uniform(0.15, 0.22));
    }
    scene.settings.tolerance = 1e-5;
    scene.settings.maxSweeps = 60;
    auto dynamics = scene.dynamics();
    const nscd::WallContact<3> walls(surface);
    double deepest = 0;
    for (int step = 0; step < 2000; ++step)
    {
        nscd::Vectors<3> force(27);
        const Point common(std::sin(0.01 * step), std::cos(0.017 * step), std::sin(0.023 * step));
        for (Point& f : force)
        {
            f = strength * g * (common + Point(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
        }
        dynamics.step(force, nscd::Spins<3>(27, nscd::Spin<3>::Zero()), dt);
        deepest = std::max(deepest, wallPenetration(dynamics, walls));
    }
    for (const Point& x : dynamics.grains().position)
    {
        EXPECT_TRUE(isInside(surface, x));   // as no wall lets a grain back in, it has never been outside
    }
    return deepest;
}

TEST(TriangulatedFloor, IsFeltLikeAPlane)
{
    for (const double friction : {0.0, 0.1, 0.5})
    {
        auto pieces = rolling(friction, roughlyCutFloor()).dynamics();
        auto plane = rolling(friction, {nscd::Plane{{0, 0, 0}, {0, 0, 1}, 1}}).dynamics();
        for (int i = 0; i < 400; ++i)
        {
            const Point gravity(0.4, 0.3, -g);
            EXPECT_EQ(fall<3>(pieces, gravity, dt).contacts, 1u);
            fall<3>(plane, gravity, dt);
            ASSERT_LE((pieces.grains().position[0] - plane.grains().position[0]).norm(), 1e-11);
            ASSERT_LE((pieces.grains().velocity[0] - plane.grains().velocity[0]).norm(), 1e-11);
            ASSERT_LE((pieces.grains().spin[0] - plane.grains().spin[0]).norm(), 1e-11);
        }
        EXPECT_GT((plane.grains().position[0] - Point(-4, -3, 1)).norm(), 5);
    }
}

TEST(TriangulatedFloor, OfTwoTrianglesIsAPlane)
{
    Surface two;
    addParallelogram(two, {-100, -100, 0}, {200, 0, 0}, {0, 200, 0});
    auto triangles = rolling(0.2, two).dynamics();
    auto plane = rolling(0.2, {nscd::Plane{{0, 0, 0}, {0, 0, 1}, 1}}).dynamics();
    for (int i = 0; i < 400; ++i)
    {
        fall<3>(triangles, {1, 0, -g}, dt);
        fall<3>(plane, {1, 0, -g}, dt);
    }
    EXPECT_LE((triangles.grains().position[0] - plane.grains().position[0]).norm(), 1e-11);
    EXPECT_LE((triangles.grains().spin[0] - plane.grains().spin[0]).norm(), 1e-11);
}

TEST(TriangulatedProfile, IsFeltLikeItsSegmentsIn2D)
{
    // Without friction a sphere on a cylindrical surface moves like a disc on its section: down a slope, through a
    // trough, over a flat part, off an edge, onto a lower floor
    const double profile[][2] = {{-6, 3}, {-3, 0.5}, {-2, 0}, {-1, 0}, {1, 0.8}, {2.5, 0.8}, {2.5, -1}, {12, -1}};
    Scene<2> disc;
    Scene<3> sphere;
    for (int i = 0; i < 7; ++i)
    {
        const auto& [x, z] = profile[i];
        const auto& [nextX, nextZ] = profile[i + 1];
        disc.walls.push_back({{x, z}, {nextX, nextZ}, 1});
        addParallelogram(sphere.walls, {x, -7, z}, {nextX - x, 0, nextZ - z}, {0, 14, 0}, 1 + i % 3, i);
    }
    disc.add({-4.5, 3.2}, {0.5, 0}, 0.6);
    sphere.add({-4.5, -2, 3.2}, {0.5, 0.6, 0}, 0.6);
    auto flat = disc.dynamics();
    auto solid = sphere.dynamics();
    for (int i = 0; i < 700; ++i)
    {
        fall<2>(flat, {0, -g}, dt / 2);
        fall<3>(solid, {0, 0, -g}, dt / 2);
        const Point& x = solid.grains().position[0];
        ASSERT_NEAR(x.x(), flat.grains().position[0].x(), 1e-10);
        ASSERT_NEAR(x.z(), flat.grains().position[0].y(), 1e-10);
        ASSERT_NEAR(x.y(), -2 + 0.6 * (i + 1) * dt / 2, 1e-10);
    }
    EXPECT_GT(flat.grains().position[0].x(), 4);
}

TEST(ConvexEdge, OfTrianglesTurnsASphereAroundItWithoutOverlap)
{
    Surface table;
    addParallelogram(table, {-10, -5, 0}, {10, 0, 0}, {0, 10, 0}, 3);
    addParallelogram(table, {0, -5, 0}, {0, 0, -10}, {0, 10, 0}, 2);
    Scene<3> scene(0.3);
    scene.walls = table;
    scene.add({0, 0.1, 1}, {0.1, 0.05, 0});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 200; ++i)
    {
        EXPECT_LE(fall<3>(dynamics, up<3>(-g), 1e-3).contacts, 1u);
        EXPECT_LE(dynamics.worstOverlap(), 1e-12);
    }
    EXPECT_GT(dynamics.grains().position[0].x(), 0);
}

TEST(BoxOfTriangles, HoldsASphereInItsCornerWithThreeContacts)
{
    for (const int n : {1, 3})
    {
        Scene<3> scene(0.3);
        scene.walls = boxSurface({4, 5, 6}, n);
        scene.add({1, 1, 1});
        auto dynamics = scene.dynamics();
        const Point gravity(-2, -3, -4);
        const nscd::StepReport report = fall<3>(dynamics, gravity, dt);
        EXPECT_EQ(report.contacts, 3u);
        EXPECT_EQ(report.active, 3u);
        const double error = scene.settings.tolerance / dt;   // three contacts that friction couples: by sweeps
        EXPECT_LE(dynamics.grains().velocity[0].norm(), error);
        EXPECT_LE((dynamics.contactImpulse()[0] + dt * gravity).norm(), error);
    }
}

TEST(BoxOfTriangles, StopsASphereThatHitsItsCornerOrEdgeFromOutside)
{
    for (const Point& from : {Point(1, 1, 1), Point(1, 1, 0)})
    {
        const Point direction = from.normalized();
        const Point target(4, 4, from.z() > 0 ? 4 : 2);
        Scene<3> scene(0.3);
        scene.walls = boxSurface({4, 4, 4}, 2);
        scene.add(target + 1.5 * direction, -direction);
        auto dynamics = scene.dynamics();
        for (int i = 0; i < 100; ++i)
        {
            EXPECT_LE(fall<3>(dynamics, Point::Zero(), dt).contacts, 1u);
        }
        EXPECT_LE((dynamics.grains().position[0] - target - direction).norm(), 1e-10);
        EXPECT_LE(dynamics.grains().velocity[0].norm(), 1e-10);
    }
}

TEST(BoxOfTriangles, KeepsAgitatedSpheresInside)
{
    EXPECT_LE(agitate(centredBox(2), 10), 0.05);   // planes in place of the triangles: 0.011, from 60 sweeps
}

TEST(BoxOfTriangles, KeepsSpheresInsideWhileItTumbles)
{
    Scene<3> scene(0.3);
    scene.walls = centredBox(2, 0);
    for (int i = 0; i < 27; ++i)
    {
        scene.add(0.45 * Point(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), Point::Zero(), 0.15 + 0.002 * i);
    }
    scene.settings.tolerance = 1e-5;
    scene.settings.maxSweeps = 60;
    nscd::ContactDynamics<3> dynamics(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF,
                                      {nscd::WallBody<3>()});
    for (int step = 0; step < 1000; ++step)
    {
        const double t = step * dt;
        dynamics.setWallMotion(0, Point(std::cos(7 * t), std::sin(5 * t), 0), {std::sin(t), 2, std::cos(0.7 * t)});
        fall<3>(dynamics, up<3>(-g), dt);
        const nscd::WallBody<3>& box = dynamics.wallBodies()[0];
        for (std::size_t i = 0; i < dynamics.grains().size(); ++i)
        {
            const Point inBox = box.orientation.conjugate() * (dynamics.grains().position[i] - box.position);
            ASSERT_LE(inBox.cwiseAbs().maxCoeff(), 1 - 0.95 * dynamics.grains().radius[i]);
        }
    }
}

TEST(SphereOfTriangles, KeepsAgitatedSpheresInside)
{
    EXPECT_LE(agitate(sphereSurface(1.2, 2), 10), 0.05);
}

TEST(SurfaceOfHillsAndHollows, KeepsAgitatedSpheresInside)
{
    // A contact's normal holds for a step in which spheres go up to a radius, past edges as near as that: an error of
    // the second order in the step
    EXPECT_LE(agitate(bumpySurface(1.6, 2), 10), 0.15);
}

TEST(SphereOfTriangles, ShedsSpheresThatFallOnIt)
{
    Scene<3> scene(0.3);
    scene.walls = sphereSurface(2, 3);
    nscd::Random random(9);
    for (int i = 0; i < 16; ++i)
    {
        scene.add({i % 4 - 1.5, i / 4 - 1.5, 2.5 + random.uniform(0, 0.5)}, {0, 0, -3}, random.uniform(0.2, 0.4));
    }
    scene.settings.tolerance = 1e-6;
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 300; ++i)
    {
        fall<3>(dynamics, up<3>(-g), dt);
        for (std::size_t k = 0; k < dynamics.grains().size(); ++k)
        {
            // The faces are no nearer to the centre than 0.99 radii
            EXPECT_GE(dynamics.grains().position[k].norm(), 1.98 + 0.99 * dynamics.grains().radius[k]);
        }
    }
    for (const Point& x : dynamics.grains().position)
    {
        EXPECT_LT(x.z(), 0);
    }
}

}  // namespace triangleScenes
