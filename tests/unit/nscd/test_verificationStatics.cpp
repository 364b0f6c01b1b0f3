// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Assemblies at rest with known forces, and the energy that contacts take out.

#include "Scene.hpp"

#include <gtest/gtest.h>

namespace verificationStatics
{

using nscd::Vector;

constexpr double dt = 1e-3;

/// The grains on the floor are this far apart, so that no force between them makes the problem indeterminate; the gap
/// does not close, as that would take a speed of 1e-6 m/s.
constexpr double apart = 1e-9;

Scene<2> pyramid()
{
    Scene<2> scene;
    scene.addFloor();
    scene.add({-1 - apart, 1});
    scene.add({1 + apart, 1});
    scene.add({0, 1 + std::sqrt(4 - std::pow(1 + apart, 2))});
    return scene;
}

Scene<3> tetrahedron()
{
    Scene<3> scene;
    scene.addFloor();
    const double a = (2 + apart) / std::sqrt(3.0);
    for (int i = 0; i < 3; ++i)
    {
        scene.add({a * std::cos(2 * M_PI * i / 3), a * std::sin(2 * M_PI * i / 3), 1});
    }
    scene.add({0, 0, 1 + std::sqrt(4 - a * a)});
    return scene;
}

template <int D>
nscd::ContactDynamics<D> stacked(Scene<D> scene, double ofGrains, double ofFloor)
{
    scene.table.set(0, 0, {ofGrains});
    scene.table.set(0, 1, {ofFloor});
    scene.settings.tolerance = 1e-17;   // 1e-14 m/s: the threshold is known to 11 digits of g dt
    return scene.dynamics();
}

/// Fastest grain after the first step over g dt.
template <int D>
double departure(const Scene<D>& scene, double ofGrains, double ofFloor)
{
    auto dynamics = stacked(scene, ofGrains, ofFloor);
    return fall<D>(dynamics, up<D>(-g), dt).maxVelocity / (g * dt);
}

/// The first step moves nothing at 1 % more friction than the thresholds, and something at 1 % less of either.
template <int D>
void expectThresholds(const Scene<D>& scene, double ofGrains, double ofFloor)
{
    EXPECT_LT(departure(scene, 1.01 * ofGrains, 1.01 * ofFloor), 1e-9);
    EXPECT_GT(departure(scene, 0.99 * ofGrains, 1.01 * ofFloor), 5e-4);
    EXPECT_GT(departure(scene, 1.01 * ofGrains, 0.99 * ofFloor), 5e-4);
}

/// Normal impulses over m g dt of floor contacts and of those with the top grain.
template <int D>
void expectImpulses(const Scene<D>& scene, double ofGrains, double ofFloor, double floorImpulse, double topImpulse)
{
    auto dynamics = stacked(scene, 1.01 * ofGrains, 1.01 * ofFloor);
    fall<D>(dynamics, up<D>(-g), dt);
    const int top = static_cast<int>(scene.grains.size()) - 1;
    int floors = 0, tops = 0;
    for (const auto& c : dynamics.contacts())
    {
        const double normal = -c.force.dot(c.normal) / g;
        if (c.second < 0)
        {
            EXPECT_NEAR(std::abs(normal), floorImpulse, 1e-7);
            ++floors;
        }
        else if (c.first == top || c.second == top)
        {
            EXPECT_NEAR(std::abs(normal), topImpulse, 1e-7);
            ++tops;
        }
    }
    EXPECT_EQ(floors, top);
    EXPECT_EQ(tops, top);
}

TEST(Pyramid, StandsAndFallsOnePerCentAroundItsThresholds)
{
    const double critical = std::tan(M_PI / 12);
    EXPECT_NEAR(critical, 0.267949, 1e-6);
    EXPECT_NEAR(critical / 3, 0.0893164, 1e-7);
    expectThresholds(pyramid(), critical, critical / 3);
}

TEST(Pyramid, PressesItsFloorWithHalfOfItsWeightEach)
{
    expectImpulses(pyramid(), std::tan(M_PI / 12), std::tan(M_PI / 12) / 3, 1.5, 0.5);
}

TEST(Tetrahedron, StandsAndFallsOnePerCentAroundItsThresholds)
{
    const double critical = std::tan(0.5 * std::acos(std::sqrt(2.0 / 3)));
    EXPECT_NEAR(critical, 0.317837, 1e-6);
    EXPECT_NEAR(critical / 4, 0.0794593, 1e-7);
    expectThresholds(tetrahedron(), critical, critical / 4);
}

TEST(Tetrahedron, PressesItsFloorWithAThirdOfItsWeightEach)
{
    const double critical = std::tan(0.5 * std::acos(std::sqrt(2.0 / 3)));
    expectImpulses(tetrahedron(), critical, critical / 4, 4.0 / 3, 1.0 / 3);
}

TEST(Cradle, OfAnyLengthKeepsOneNthOfTheEnergy)
{
    for (const int n : {2, 3, 5, 8})
    {
        Scene<3> scene(0.3);
        for (int i = 0; i < n; ++i)
        {
            scene.add({2.0 * i, 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0});
        }
        auto dynamics = scene.dynamics();
        fall<3>(dynamics, Vector<3>::Zero(), dt);
        EXPECT_NEAR(2 * kineticEnergy(dynamics.grains()), 1.0 / n, 1e-9);   // tolerance/dt = 1e-10
    }
}

TEST(ContactWork, WithoutBouncingIsNegativeAndThatOfTheLedger)
{
    // Nothing but contacts acts on the grains: what they lose is the contacts' work
    Scene<3> scene = agitated<3>(6, 0.5, 10);
    scene.settings.tolerance = 1e-15;
    scene.settings.maxSweeps = 20000;
    auto dynamics = scene.dynamics();
    double energy = kineticEnergy(dynamics.grains());
    for (int i = 0; i < 100; ++i)
    {
        const nscd::StepReport report = fall<3>(dynamics, Vector<3>::Zero(), 5e-3);
        const double next = kineticEnergy(dynamics.grains());
        ASSERT_LE(report.contactWork, 1e-12 * energy);
        ASSERT_NEAR(next - energy, report.contactWork, 1e-12 * energy);
        energy = next;
    }
    EXPECT_LT(energy, 0.5 * kineticEnergy(scene.grains));
}

}  // namespace verificationStatics
