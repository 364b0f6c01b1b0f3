// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Gases and a shaken bed of grains that bounce, against event-driven dynamics and against themselves with short steps.

#include "EventDriven.hpp"
#include "Gas.hpp"

#include <gtest/gtest.h>

namespace
{

constexpr int seeds = 24;

/// sqrt(K_0/K) - 1, which grows in proportion to time (Haff 1983, doi:10.1017/S0022112083003419).
double cooled(double before, double now) { return std::sqrt(before / now) - 1; }

struct Cooling
{
    double restitution, fraction, duration;
};

void PrintTo(const Cooling& c, std::ostream* os) { *os << "e " << c.restitution << ", solid fraction " << c.fraction; }

template <int D>
double spacing(double fraction)
{
    return std::pow((D == 2 ? M_PI : 4 * M_PI / 3) / fraction, 1.0 / D);
}

/// Mean over the seeds; the way in a step is that of the root mean square velocity, in diameters.
template <int D>
void compareCooling(const Cooling& c, std::initializer_list<double> ways, int perSide)
{
    double exact = 0;
    for (int seed = 1; seed <= seeds; ++seed)
    {
        const Gas<D> gas(perSide, spacing<D>(c.fraction), seed);
        EventDriven<D> reference(gas.scene.grains.position, gas.scene.grains.velocity, 1, gas.side, c.restitution);
        const double before = reference.squareOfSpeeds();
        reference.advance(c.duration);
        exact += cooled(before, reference.squareOfSpeeds()) / seeds;
    }
    for (const double way : ways)
    {
        const int steps = static_cast<int>(std::ceil(c.duration * std::sqrt(D) / (2 * way)));
        double ours = 0;
        for (int seed = 1; seed <= seeds; ++seed)
        {
            Gas<D> gas(perSide, spacing<D>(c.fraction), seed);
            gas.scene.table.set(0, 0, {0, c.restitution});
            auto dynamics = gas.scene.dynamics();
            const double before = kineticEnergy<D>(dynamics.grains());
            for (int i = 0; i < steps; ++i)
            {
                fall<D>(dynamics, nscd::Vector<D>::Zero(), c.duration / steps);
            }
            ours += cooled(before, kineticEnergy<D>(dynamics.grains())) / seeds;
        }
        std::printf("%d-D, e %.2f, solid fraction %.2f, %.2f d per step: rate / exact %.4f\n", D, c.restitution,
                    c.fraction, way, ours / exact);
        // The means over the seeds scatter by about 0.7 %
        EXPECT_NEAR(ours / exact, 1, 0.03) << way << " d per step";
    }
}

class CoolingDiscs : public testing::TestWithParam<Cooling>
{
};

class CoolingSpheres : public testing::TestWithParam<Cooling>
{
};

TEST_P(CoolingDiscs, IsThatOfEventDrivenDynamics)
{
    compareCooling<2>(GetParam(), {0.02, 0.05, 0.1, 0.2}, 14);
}

TEST_P(CoolingSpheres, IsThatOfEventDrivenDynamics)
{
    compareCooling<3>(GetParam(), {0.02, 0.1, 0.2}, 6);
}

// The time is that of some ten collisions of each grain
INSTANTIATE_TEST_SUITE_P(Gas, CoolingDiscs,
                         testing::Values(Cooling{0.97, 0.2, 30}, Cooling{0.97, 0.45, 10}, Cooling{0.97, 0.6, 4},
                                         Cooling{0.8, 0.2, 20}, Cooling{0.8, 0.45, 6}, Cooling{0.8, 0.6, 3}));

INSTANTIATE_TEST_SUITE_P(Gas, CoolingSpheres,
                         testing::Values(Cooling{0.97, 0.2, 10}, Cooling{0.97, 0.4, 3}, Cooling{0.8, 0.2, 8},
                                         Cooling{0.8, 0.4, 2}));

/// Height of the centre of mass of 300 discs of 5 mm over the middle of a floor that shakes them at 8 g, mean over
/// time, in diameters.
double shakenHeight(double dt)
{
    const double d = 5e-3, amplitude = d, omega = std::sqrt(8 * g / amplitude);
    Scene<2> scene;
    scene.table.set(0, 0, {0.1, 0.97});
    scene.table.set(0, 1, {0.1, 0.97});
    nscd::Random random(3);
    for (int i = 0; i < 300; ++i)
    {
        scene.add({d * (1.05 * (i % 20) + 0.5), d * (2.5 + 1.05 * (i / 20))},
                  {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)}, 0.5 * d);
    }
    scene.settings.period[0] = 21 * d;
    scene.settings.tolerance = 2e-6 * d;
    scene.settings.maxSweeps = 200;
    scene.walls.push_back({{-1, 0}, {1, 0}, 1, 0});
    nscd::ContactDynamics<2> dynamics(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF,
                                      {nscd::WallBody<2>{}});
    double height = 0;
    const int steps = static_cast<int>(100 * 2 * M_PI / omega / dt), settling = steps / 5;
    for (int i = 0; i < steps; ++i)
    {
        const auto floorAt = [&](int step) { return amplitude * std::sin(omega * step * dt); };
        dynamics.setWallMotion(0, {0, (floorAt(i + 1) - floorAt(i)) / dt}, nscd::Spin<2>(0));
        fall<2>(dynamics, up<2>(-g), dt);
        for (const auto& x : dynamics.grains().position)
        {
            height += i >= settling ? x[1] / d / (300.0 * (steps - settling)) : 0;
        }
    }
    return height;
}

TEST(ShakenBed, HasAHeightThatDoesNotHangOnTheStep)
{
    const double coarse = shakenHeight(1e-3), fine = shakenHeight(1e-4);
    std::printf("height %.3f d at 1e-3 s, %.3f d at 1e-4 s\n", coarse, fine);
    EXPECT_NEAR(coarse, fine, 0.02 * fine);   // the noise of a mean over 80 periods is about 0.5 %
}

}  // namespace
