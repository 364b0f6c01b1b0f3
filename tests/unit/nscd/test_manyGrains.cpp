// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Collisions and static assemblies with exact answers, and what must hold for every assembly.

#include "Scene.hpp"

#include "nscd/dynamics/State.hpp"
#include "nscd/packing/Packing.hpp"

#include <cstdio>
#include <gtest/gtest.h>

using nscd::Vector;

namespace
{

/// Speed after one step from rest over g dt: tells a stable assembly from one that starts to move.
template <int D>
double startingSpeed(Scene<D> scene, double frictionOfGrains, double frictionOfFloor)
{
    scene.addFloor();
    scene.table.set(0, 0, {frictionOfGrains});
    scene.table.set(0, 1, {frictionOfFloor});
    scene.settings.tolerance = 1e-16;
    auto dynamics = scene.dynamics();
    return fall<D>(dynamics, up<D>(-g), 1e-3).maxVelocity / (g * 1e-3);
}

Scene<2> pyramid()
{
    Scene<2> scene;
    scene.add({-1, 1});
    scene.add({1, 1});
    scene.add({0, 1 + std::sqrt(3.0)});
    return scene;
}

Scene<3> tetrahedron()
{
    Scene<3> scene;
    const double a = 2 / std::sqrt(3.0);
    for (int i = 0; i < 3; ++i)
    {
        scene.add({a * std::cos(2 * M_PI * i / 3), a * std::sin(2 * M_PI * i / 3), 1});
    }
    scene.add({0, 0, 1 + 2 * std::sqrt(2.0 / 3)});
    return scene;
}

template <int D>
Vector<D> momentum(const nscd::Grains<D>& grains)
{
    Vector<D> sum = Vector<D>::Zero();
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        sum += grains.mass[i] * grains.velocity[i];
    }
    return sum;
}

template <int D>
void expectMomentumAndEnergyBalance(int perSide)
{
    Scene<D> scene = agitated<D>(perSide, 0.5);
    scene.walls.clear();
    for (std::size_t i = 0; i < scene.grains.size(); ++i)   // towards the middle
    {
        scene.grains.velocity[i] -= scene.grains.position[i] - Vector<D>::Constant(1.1 * perSide);
    }
    auto dynamics = scene.dynamics();
    const Vector<D> before = momentum(dynamics.grains());
    double energy = kineticEnergy(dynamics.grains());
    const double scale = std::sqrt(energy * static_cast<double>(scene.grains.size()));
    std::size_t contacts = 0;
    for (int i = 0; i < 100; ++i)
    {
        contacts += fall<D>(dynamics, Vector<D>::Zero(), 1e-2).active;
        EXPECT_LE((momentum(dynamics.grains()) - before).norm(), 1e-13 * scale);
        const double next = kineticEnergy(dynamics.grains());
        EXPECT_LE(next, energy * (1 + 1e-12));
        energy = next;
    }
    EXPECT_GT(contacts, 1000u);
}

/// A trial says what the step then does, and leaves all else as it was: bodies move bit for bit as without it.
template <int D>
void expectTrialToForesee()
{
    Scene<D> scene = agitated<D>(3, 0.3);
    scene.table.set(0, 0, {0.3, 0.6});
    scene.table.set(0, 1, {0.3, 0.6});
    auto dynamics = scene.dynamics(), other = scene.dynamics();
    const nscd::Grains<D>& grains = dynamics.grains();
    const std::size_t n = grains.size();
    const nscd::Vectors<D> force(n, up<D>(-1));
    const nscd::Spins<D> torque(n, nscd::Spin<D>::Zero());
    constexpr double length = 0.1;

    dynamics.foresee(grains.mass, force, torque, length);
    const nscd::Vectors<D> impulse = dynamics.contactImpulse();
    const nscd::Spins<D> spinImpulse = dynamics.contactSpinImpulse();
    EXPECT_EQ(dynamics.lastTimeStep(), length);
    EXPECT_TRUE(sameBits(grains.position, other.grains().position));
    EXPECT_TRUE(sameBits(grains.velocity, other.grains().velocity));

    EXPECT_GT(dynamics.step(force, torque, length).contacts, 0u);
    other.step(force, torque, length);
    EXPECT_TRUE(sameBits(grains.position, other.grains().position));
    EXPECT_TRUE(sameBits(grains.velocity, other.grains().velocity));
    EXPECT_TRUE(sameBits(grains.spin, other.grains().spin));
    EXPECT_TRUE(sameBits(impulse, other.contactImpulse()));
    EXPECT_TRUE(sameBits(spinImpulse, other.contactSpinImpulse()));
}

/// What holds a grain lasts; what stops one is over.
template <int D>
void expectLandingNotToLast()
{
    Scene<D> scene;
    scene.addFloor();
    scene.add(up<D>(1));
    scene.add(3 * nscd::Vector<D>::Unit(0) + up<D>(1.01), up<D>(-20));
    auto dynamics = scene.dynamics();
    constexpr double length = 1e-3;
    const double weight = g * dynamics.grains().mass[0];
    const auto held = [&](int i) { return dynamics.lasting().force[i][D - 1] / weight; };

    for (int step = 0; step < 2; ++step)
    {
        fall<D>(dynamics, up<D>(-g), length);
        EXPECT_EQ(held(0), 0);
        EXPECT_GT(dynamics.contactImpulse()[1][D - 1], 100 * weight * length);
        EXPECT_EQ(held(1), 0);
    }
    fall<D>(dynamics, up<D>(-g), length);
    EXPECT_NEAR(held(0), 1, 1e-6);
    EXPECT_NEAR(held(1), 1, 1e-6);
}

}  // namespace

TEST(ManyGrains, LandingDoesNotLast2D) { expectLandingNotToLast<2>(); }
TEST(ManyGrains, LandingDoesNotLast3D) { expectLandingNotToLast<3>(); }
TEST(ManyGrains, TrialForesees2D) { expectTrialToForesee<2>(); }
TEST(ManyGrains, TrialForesees3D) { expectTrialToForesee<3>(); }

TEST(TwoSpheres, ExchangeImpulsesOfAnInelasticFrictionalCollision)
{
    const double mu = 0.3;
    for (const double tangential : {0.5, 2.0})
    {
        Scene<3> scene(mu);
        scene.add({0, 0, 0}, {1, tangential, 0});
        scene.add({2, 0, 0});
        auto dynamics = scene.dynamics();
        fall<3>(dynamics, Vector<3>::Zero(), 1e-3);
        const double impulse = std::min(mu / 2, tangential / 7);
        EXPECT_LE((dynamics.grains().velocity[0] - Vector<3>(0.5, tangential - impulse, 0)).norm(), 1e-12);
        EXPECT_LE((dynamics.grains().velocity[1] - Vector<3>(0.5, impulse, 0)).norm(), 1e-12);
    }
}

TEST(Cradle, SharesTheVelocityOfTheFirstBall)
{
    Scene<2> scene;
    for (int i = 0; i < 5; ++i)
    {
        scene.add({2.0 * i, 0}, {i == 0 ? 1.0 : 0.0, 0});
    }
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, Vector<2>::Zero(), 1e-3);
    for (const Vector<2>& v : dynamics.grains().velocity)
    {
        EXPECT_NEAR(v.x(), 0.2, 1e-9);   // tolerance/dt = 1e-10, five contacts
    }
    EXPECT_NEAR(kineticEnergy(dynamics.grains()), 0.1, 1e-9);
}

TEST(Pyramid, StandsJustAboveTheThresholdsOfFriction)
{
    const double ofGrains = std::tan(M_PI / 12);
    const double ofFloor = ofGrains / 3;
    EXPECT_LT(startingSpeed(pyramid(), 1.01 * ofGrains, 1.01 * ofFloor), 1e-8);
    EXPECT_GT(startingSpeed(pyramid(), 0.99 * ofGrains, 1.01 * ofFloor), 1e-4);
    EXPECT_GT(startingSpeed(pyramid(), 1.01 * ofGrains, 0.99 * ofFloor), 1e-4);
}

TEST(Tetrahedron, StandsJustAboveTheThresholdsOfFriction)
{
    const double ofGrains = std::tan(0.5 * std::acos(std::sqrt(2.0 / 3)));
    const double ofFloor = ofGrains / 4;
    EXPECT_LT(startingSpeed(tetrahedron(), 1.01 * ofGrains, 1.01 * ofFloor), 1e-8);
    EXPECT_GT(startingSpeed(tetrahedron(), 0.99 * ofGrains, 1.01 * ofFloor), 1e-4);
    EXPECT_GT(startingSpeed(tetrahedron(), 1.01 * ofGrains, 0.99 * ofFloor), 1e-4);
}

TEST(Column, ContactsCarryTheWeightAbove)
{
    constexpr int n = 12;
    constexpr double dt = 1e-3;
    Scene<2> scene(0.5);
    scene.addFloor();
    for (int i = 0; i < n; ++i)
    {
        scene.add({0, 1 + 2.0 * i});
    }
    auto dynamics = scene.dynamics();
    EXPECT_TRUE(fall<2>(dynamics, up<2>(-g), dt).converged);
    const std::string file = testing::TempDir() + "column.h5";
    dynamics.save(file, 0);
    const nscd::State<2> state = nscd::readState<2>(file);
    std::remove(file.c_str());
    ASSERT_EQ(state.impulses.size(), static_cast<std::size_t>(n));
    for (const nscd::NamedImpulse<2>& contact : state.impulses)
    {
        const int carried = contact.b < 0 ? n : n - 1 - contact.a;
        EXPECT_NEAR(contact.impulse.normal, carried * g * dt, n * n * 1e-10);   // tolerance/dt times the condition n^2
        EXPECT_NEAR(contact.impulse.tangential, 0, 1e-12);
    }
}

TEST(Column, NeedsFarFewerSweepsOnceTheImpulsesAreKnown)
{
    Scene<2> scene;
    scene.addFloor();
    for (int i = 0; i < 20; ++i)
    {
        scene.add({0, 1 + 2.0 * i});
    }
    scene.settings.tolerance = 1e-9;
    auto dynamics = scene.dynamics();
    const int cold = fall<2>(dynamics, up<2>(-g), 1e-3).sweeps;
    fall<2>(dynamics, up<2>(-g), 1e-3);
    EXPECT_LT(fall<2>(dynamics, up<2>(-g), 1e-3).sweeps, cold / 50);
    EXPECT_LT(fall<2>(dynamics, up<2>(-g), 2e-3).sweeps, cold / 50);   // impulses scale with the step
}

TEST(Row, IsHitInTimeThroughGapsThatOpenedWithinTheStep)
{
    Scene<2> scene;
    for (int i = 0; i < 6; ++i)
    {
        scene.add({2.1 * i, 0}, {i == 0 ? 1.0 : 0.0, 0});
    }
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, Vector<2>::Zero(), 0.9);   // the first one alone would travel 0.9 in this step
    EXPECT_LE(dynamics.worstOverlap(), 1e-10);
}

TEST(Row, PushedByAHeavyGrainStopsBeforeWhatIsFarFromThat)
{
    Scene<2> scene;
    scene.add({0, 0}, {1, 0}, 1, 1e3);
    for (int i = 1; i <= 10; ++i)
    {
        scene.add({2.0 * i, 0});
    }
    scene.add({22.5, 0});   // farther than the last one of the row would go, if it were alone
    auto dynamics = scene.dynamics();
    const auto report = fall<2>(dynamics, Vector<2>::Zero(), 0.9);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.subSteps, 1);
    EXPECT_LE(dynamics.worstOverlap(), 1e-10);
    const nscd::Grains<2>& grains = dynamics.grains();
    EXPECT_NEAR(grains.velocity[11].x(), grains.velocity[10].x() - 0.5 / 0.9, 1e-10);
    EXPECT_GT(grains.velocity[11].x(), 0.4);
}

TEST(Agitation, ConservesMomentumAndCreatesNoEnergy)
{
    expectMomentumAndEnergyBalance<2>(12);
    expectMomentumAndEnergyBalance<3>(6);
}

TEST(Overlap, IsRemovedWithoutSettingGrainsInMotion)
{
    Scene<3> scene(0.3);
    scene.add({0, 0, 0});
    scene.add({1.95, 0, 0});
    auto dynamics = scene.dynamics();
    EXPECT_NEAR(dynamics.worstOverlap(), 0.05, 1e-15);
    fall<3>(dynamics, Vector<3>::Zero(), 1e-3);
    EXPECT_LE(dynamics.worstOverlap(), 1e-12);
    EXPECT_EQ(kineticEnergy(dynamics.grains()), 0);
    EXPECT_NEAR(dynamics.grains().position[0].x(), -0.025, 1e-12);
}

TEST(Overlap, IsNotPushedOnToGrainsWithoutAContact)
{
    Scene<3> scene;
    scene.add({0, 0, 0});
    scene.add({1.91, 0, 0});
    scene.add({3.94, 0, 0});   // a gap of 0.03: no contact, but the overlap of 0.09 is more than that
    scene.add({5.97, 0, 0});
    auto dynamics = scene.dynamics();
    EXPECT_TRUE(fall<3>(dynamics, Vector<3>::Zero(), 1e-3).converged);
    EXPECT_LE(dynamics.worstOverlap(), 1e-12);
    EXPECT_EQ(kineticEnergy(dynamics.grains()), 0);
}

TEST(Overlap, OfGrainsThatFallStaysSmallWhereSweepsRunOut)
{
    Scene<2> scene = agitated<2>(20, 0.4);
    scene.settings.maxSweeps = 30;
    auto dynamics = scene.dynamics();
    bool converged = true;
    double worst = 0;
    for (int i = 0; i < 200; ++i)
    {
        const nscd::StepReport report = fall<2>(dynamics, up<2>(-g), 2e-2);
        converged = converged && report.converged;
        worst = std::max(worst, report.worstOverlap);
    }
    EXPECT_FALSE(converged);
    EXPECT_LT(worst, 0.01);   // of the largest radius; 0.028 when a tenth of any depth is removed
}

TEST(Overlap, OfCoincidentGrainsIsRemovedInTheEnd)
{
    Scene<2> scene(0.3);
    scene.add({1, 1});
    scene.add({1, 1});
    auto dynamics = scene.dynamics();
    for (int i = 0; i < 30; ++i)
    {
        fall<2>(dynamics, Vector<2>::Zero(), 1e-3);
    }
    EXPECT_LE(dynamics.worstOverlap(), 1e-12);
}

TEST(HexagonalPacking, OfTenThousandDiscsStaysAtRest)
{
    constexpr double r = 1.5e-3;
    const double rowHeight = std::sqrt(3.0) * r;
    const Vector<2> size(201 * r, 2 * r + 99 * rowHeight);
    Scene<2> scene(0.3);
    for (const Vector<2>& x : nscd::hexagonal<2>({Vector<2>::Zero(), size}, r))
    {
        scene.add(x, Vector<2>::Zero(), r, 1500 * M_PI * r * r);
    }
    ASSERT_EQ(scene.grains.size(), 10000u);
    scene.addBox(size);
    scene.settings = nscd::Settings();
    auto dynamics = scene.dynamics();
    nscd::StepReport last;
    for (int i = 0; i < 30; ++i)
    {
        last = fall<2>(dynamics, up<2>(-g), 1e-3);
    }
    double farthest = 0;
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        farthest = std::max(farthest, (dynamics.grains().position[i] - scene.grains.position[i]).norm());
    }
    EXPECT_LT(farthest, 0.2 * r);   // all impulses start from zero under 100 layers; free fall would be 3 r
    EXPECT_LT(last.maxVelocity, 2 * g * 1e-3);
    EXPECT_LT(last.worstOverlap, 0.01 * r);
}

TEST(DeepPile, NeitherBouncesNorSinksIntoItselfWithFewSweeps)
{
    const Vector<2> size(21, 2 + 39 * std::sqrt(3.0));
    Scene<2> scene(0.3);
    for (const Vector<2>& x : nscd::hexagonal<2>({Vector<2>::Zero(), size}, 1))
    {
        scene.add(x);
    }
    scene.addBox(size);
    scene.settings.tolerance = 1e-5;
    scene.settings.maxSweeps = 8;   // a cold solution would need the square of the 40 layers
    auto dynamics = scene.dynamics();
    nscd::StepReport last;
    for (int i = 0; i < 3000; ++i)
    {
        last = fall<2>(dynamics, up<2>(-g), 1e-2);
    }
    EXPECT_LT(last.worstOverlap, 0.02);
    EXPECT_LT(last.maxVelocity, g * 1e-2);   // what gravity gives in one step
}

TEST(NoGrains, CanBeAdvanced)
{
    Scene<2> scene;
    scene.addFloor();
    auto dynamics = scene.dynamics();
    const nscd::StepReport report = fall<2>(dynamics, up<2>(-g), 1e-3);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.contacts, 0u);
}
