// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Conduction through a network of contacts.

#include "Messages.hpp"
#include "Scene.hpp"

#include "nscd/heat/Conduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using nscd::Conduction;
using nscd::ContactForce;
using nscd::ThermalContact;
using nscd::ThermalWall;
using nscd::Vector;

namespace
{

/// Grains of unit radius and what touches what; the conductance of a contact is what presses it together.
struct Network
{
    nscd::Grains<3> grains;
    std::vector<double> capacity;
    std::vector<ContactForce<3>> contacts;
    std::vector<ThermalWall> walls;
    Conduction<3> conduction{{{1, 1, 0}}, 1, [](const ThermalContact& c) { return c.force; }};

    void add(double temperature, double c = 1)
    {
        grains.resize(grains.size() + 1);
        grains.radius.back() = 1;
        grains.temperature.back() = temperature;
        capacity.push_back(c);
    }

    void join(int i, int j, double conductance)
    {
        const Vector<3> n = Vector<3>::UnitX();
        contacts.push_back({i, j, Vector<3>::Zero(), n, conductance * n, 0, conductance});
    }

    std::vector<double> advance(double dt)
    {
        const nscd::Heated heated = conduction.advance(grains, capacity, contacts, walls, dt);
        grains.temperature = heated.temperature;
        return heated.wallHeat;
    }

    /// Sum of C f(T).
    template <class F>
    double sum(F&& f) const
    {
        double total = 0;
        for (std::size_t i = 0; i < capacity.size(); ++i)
        {
            total += capacity[i] * f(grains.temperature[i]);
        }
        return total;
    }

    double energy() const
    {
        return sum([](double t) { return t; });
    }

    double entropy() const
    {
        return sum([](double t) { return std::log(t); });
    }
};

/// 300 grains in three loosely joined heaps, conductances and capacities over orders of magnitude.
Network random(bool withWalls)
{
    Network network;
    nscd::Random number(11);
    for (int i = 0; i < 300; ++i)
    {
        network.add(number.uniform(300, 400), std::pow(10, number.uniform(-2, 2)));
    }
    for (int c = 0; c < 900; ++c)
    {
        const int heap = 100 * (c % 3);
        const int i = heap + static_cast<int>(number.uniform(0, 100)),
                  j = heap + static_cast<int>(number.uniform(0, 100));
        if (i != j)
        {
            network.join(i, j, std::pow(10, number.uniform(-4, 1)));
        }
    }
    if (withWalls)
    {
        network.walls = {{0, 350.0}, {0, 500.0}, {0, {}}};
        for (int c = 0; c < 10; ++c)
        {
            network.join(c, ~0, 0.1 * (c + 1));
            network.join(105 - c, ~1, 0.01);  // the first two heaps
            network.join(250 + c, ~2, 1);
        }
    }
    return network;
}

/// Temperature difference of two grains, C 2 and 3 J/K, H 1.2 W/K, after 1 s, over that at the start.
double relaxation(int steps)
{
    Network pair;
    pair.add(400, 2);
    pair.add(300, 3);
    pair.join(0, 1, 1.2);
    for (int i = 0; i < steps; ++i)
    {
        pair.advance(1.0 / steps);
    }
    return (pair.grains.temperature[0] - pair.grains.temperature[1]) / 100;
}

}  // namespace

TEST(Conduction, OfTwoGrainsRelaxesExponentially)
{
    // exp(-H t (1/C1 + 1/C2)); implicit Euler is 1/(1 + 1/n)^n, off by 1/(2 n)
    const double exact = std::exp(-1.2 * (1.0 / 2 + 1.0 / 3));
    EXPECT_NEAR(relaxation(1000000) / exact, 1, 1e-6);
    const double coarse = relaxation(50) - exact, fine = relaxation(100) - exact;
    EXPECT_NEAR(coarse / fine, 2, 0.03);
}

TEST(Conduction, BetweenTwoWallsBecomesLinear)
{
    Network chain;
    chain.walls = {{0, 300.0}, {0, 420.0}};
    for (int i = 0; i < 9; ++i)
    {
        chain.add(350, 0.5 + i);
        chain.join(i, i < 8 ? i + 1 : ~1, 2);
    }
    chain.join(0, ~0, 2);
    std::vector<double> heat;
    for (int step = 0; step < 400; ++step)
    {
        heat = chain.advance(10);
    }
    for (int i = 0; i < 9; ++i)
    {
        EXPECT_NEAR(chain.grains.temperature[i], 300 + 120 * (i + 1) / 10.0, 1e-6);
    }
    // Ten conductances of 2 W/K in series, for 10 s
    EXPECT_NEAR(heat[1], 10 * 120 * 2 / 10.0, 1e-6);
    EXPECT_NEAR(heat[0], -heat[1], 1e-6);
}

TEST(Conduction, ReachesTheSteadyStateInOneLongStep)
{
    Network chain;
    chain.walls = {{0, 300.0}, {0, 420.0}};
    for (int i = 0; i < 9; ++i)
    {
        chain.add(350);
        chain.join(i, i < 8 ? i + 1 : ~1, 2);
    }
    chain.join(0, ~0, 2);
    chain.advance(1e12);
    for (int i = 0; i < 9; ++i)
    {
        EXPECT_NEAR(chain.grains.temperature[i], 300 + 120 * (i + 1) / 10.0, 1e-9);
    }
}

TEST(Conduction, KeepsEnergyAndRaisesEntropy)
{
    for (const double dt : {1e-9, 1e-3, 1.0, 1e3, 1e9})
    {
        Network network = random(false);
        const double energy = network.energy();
        double entropy = network.entropy();
        for (int step = 0; step < 20; ++step)
        {
            network.advance(dt);
            EXPECT_NEAR(network.energy() / energy, 1, 1e-14);
            EXPECT_GE(network.entropy(), entropy * (1 - 1e-14));  // round-off once all is even
            entropy = network.entropy();
        }
    }
}

TEST(Conduction, ClosesTheLedgerWithTheWalls)
{
    for (const double dt : {1e-3, 1.0, 1e3, 1e9})
    {
        Network network = random(true);
        for (int step = 0; step < 3; ++step)
        {
            const std::vector<double> before = network.grains.temperature;
            const std::vector<double> heat = network.advance(dt);
            double gained = 0, turnover = std::abs(heat[0]) + std::abs(heat[1]);
            for (std::size_t i = 0; i < before.size(); ++i)
            {
                gained += network.capacity[i] * (network.grains.temperature[i] - before[i]);
                turnover += std::abs(network.capacity[i] * (network.grains.temperature[i] - before[i]));
            }
            // The adiabatic heap's energy is kept to the round-off of its temperatures
            const double roundOff = 1e-15 * network.energy();
            EXPECT_NEAR(heat[0] + heat[1], gained, 1e-12 * turnover + roundOff);
            EXPECT_EQ(heat[2], 0);
        }
    }
}

TEST(Conduction, LeavesNoGrainOutsideTheRangeOfTemperatures)
{
    for (const double dt : {1e-6, 1e-2, 1.0, 1e2, 1e4, 1e8, 1e12})
    {
        Network network = random(true);
        for (int step = 0; step < 5; ++step)
        {
            network.advance(dt);
            const auto [low, high] =
                std::minmax_element(network.grains.temperature.begin(), network.grains.temperature.end());
            EXPECT_GE(*low, 300 - 1e-9);
            EXPECT_LE(*high, 500 + 1e-9);
        }
    }
}

TEST(Conduction, DoesNotTouchGrainsThatNothingTouches)
{
    Network network;
    network.walls = {{0, 900.0}, {0, {}}};
    for (const double t : {300.1, 350.7, 400.3})
    {
        network.add(t);
    }
    network.join(0, 1, 0);
    network.join(1, ~0, 0);
    network.join(2, ~1, 5);  // adiabatic
    const std::vector<double> before = network.grains.temperature;
    EXPECT_EQ(network.advance(1), std::vector<double>(2, 0.0));
    EXPECT_EQ(network.grains.temperature, before);
}

TEST(Conduction, TakesWhatPressesTheSurfacesTogetherAndTheMaterialsOfBothBodies)
{
    nscd::Grains<3> grains;
    grains.resize(2);
    grains.radius = {1e-3, 2e-3};
    grains.material = {1, 0};
    const nscd::ThermalMaterial glass{1.4, 6e10, 0.22}, steel{50, 2.1e11, 0.3};
    const Conduction<3> conduction({glass, steel});
    const ContactForce<3> pair{0, 1, {0, 0, 0}, {0, 0, 1}, {5e-4, 2e-4, -7e-4}, 0, 1e-3};
    EXPECT_DOUBLE_EQ(conduction.conductance(pair, grains, {}),
                     nscd::conductance::spheres({steel, glass, 1e-3, 2e-3, 1e-3, 1}));
    const ContactForce<3> wall{1, ~1, {0, 0, 0}, {0, 0, -1}, {5e-4, 2e-4, 7e-4}, 0, 1e-3};
    EXPECT_DOUBLE_EQ(conduction.conductance(wall, grains, {{0, {}}, {1, 300.0}}),
                     nscd::conductance::spheres({glass, steel, 2e-3, HUGE_VAL, 1e-3, 1}));
}

TEST(Conduction, OfAGrainAtRestFollowsFromItsWeight)
{
    // The contacts are those of the dynamics: two spheres on top of each other, the lower on the floor
    Scene<3> scene;
    const double radius = 1e-3, mass = 1e-5;
    scene.add({0, 0, radius}, {0, 0, 0}, radius, mass);
    scene.add({0, 0, 3 * radius}, {0, 0, 0}, radius, mass);
    scene.addFloor();
    auto dynamics = scene.dynamics();
    fall<3>(dynamics, up<3>(-g), 1e-4);
    const std::vector<ContactForce<3>> contacts = dynamics.contacts();
    ASSERT_EQ(contacts.size(), 2u);

    const nscd::ThermalMaterial glass{1.4, 6e10, 0.22}, steel{50, 2.1e11, 0.3};
    const Conduction<3> conduction({glass, steel});
    for (const ContactForce<3>& contact : contacts)
    {
        const bool onFloor = contact.second < 0;
        const ThermalContact expected{
            glass, onFloor ? steel : glass, radius, onFloor ? HUGE_VAL : radius, (onFloor ? 2 : 1) * mass * g, 1};
        EXPECT_NEAR(conduction.conductance(contact, dynamics.grains(), {{1, 300.0}})
                        / nscd::conductance::spheres(expected),
                    1, 1e-6);  // tolerance/(g dt^2)
    }
}

TEST(Conduction, GoesOnInACohesiveContactUntilItBreaks)
{
    // A sphere hangs on a heavy one.  Without weight the surfaces press on each other with the attraction, under its
    // weight with what is left of it.
    const double radius = 1e-3, mass = 1e-5, cohesion = 1.5 * mass * g, dt = 1e-4;
    Scene<3> scene;
    scene.table.set(0, 0, {0.3, 0, 0, cohesion});
    scene.add({0, 0, 0}, {0, 0, -1e-4}, radius, 1e6);
    scene.add({0, 0, -2 * radius}, {0, 0, 0}, radius, mass);
    scene.grains.temperature = {400, 300};
    auto dynamics = scene.dynamics();
    const nscd::ThermalMaterial glass{1.4, 6e10, 0.22};
    const Conduction<3> conduction({glass});
    const auto pull = [&](double weights)
    {
        dynamics.step({{0, 0, 0}, {0, 0, -weights * mass * g}}, nscd::Spins<3>(2, nscd::Spin<3>::Zero()), dt);
        return dynamics.contacts();
    };
    pull(0);   // the impact
    for (const double weights : {0.0, 1.0, 1.4})
    {
        const std::vector<ContactForce<3>> contacts = pull(weights);
        ASSERT_EQ(contacts.size(), 1u);
        EXPECT_NEAR(contacts[0].force.dot(contacts[0].normal), -weights * mass * g, 1e-9 * cohesion);
        const double expected =
            nscd::conductance::spheres({glass, glass, radius, radius, cohesion - weights * mass * g, 1});
        EXPECT_NEAR(conduction.conductance(contacts[0], dynamics.grains(), {}) / expected, 1, 1e-6);
        const double hotter = contacts[0].first == 0 ? 100 : -100;
        EXPECT_NEAR(conduction.heatFlow(contacts[0], dynamics.grains(), {}) / (hotter * expected), 1, 1e-6);
    }
    // It has pulled in the step in which it breaks
    const std::vector<ContactForce<3>> broken = pull(1.6);
    ASSERT_EQ(broken.size(), 1u);
    EXPECT_NEAR(broken[0].force.dot(broken[0].normal), -cohesion, 1e-9 * cohesion);
    EXPECT_EQ(broken[0].pressing, 0);
    EXPECT_EQ(conduction.conductance(broken[0], dynamics.grains(), {}), 0);
    EXPECT_TRUE(pull(1.6).empty());
}

TEST(Conduction, OfAClusterHasTheRadiusOfTheMemberThatTouches)
{
    nscd::Grains<2> grains;
    grains.resize(1);
    grains.clusters = {nscd::makeRod<2>(3, 2)};
    grains.shape[0] = 0;
    grains.radius[0] = 0.01;
    grains.position[0] = {1, 2};
    grains.orientation[0] = nscd::Orientation<2>(M_PI / 2);  // upright: its foot is 0.01 below
    const double member = 0.01 / 2;
    const Conduction<2> conduction({{1, 1e9, 0.3}}, 1, [](const ThermalContact& c) { return c.firstRadius; });
    const ContactForce<2> contact{0, ~0, {1, 1.99}, {0, -1}, {0, -1}, 0, 1};
    EXPECT_NEAR(conduction.conductance(contact, grains, {{0, {}}}), member, 1e-12);
}

TEST(Conduction, RefusesSenselessInput)
{
    const auto material = [](nscd::ThermalMaterial m) { return invalid([&] { Conduction<2>({{1, 1, 0}, m}); }); };
    EXPECT_EQ(material({0, 1, 0}), "conduction: material 1: conductivity 0 W/m/K is not positive");
    EXPECT_EQ(material({1, -1, 0}), "conduction: material 1: Young's modulus -1 Pa is not positive");
    EXPECT_EQ(material({1, 1, 0.6}), "conduction: material 1: Poisson ratio 0.6 is not within (-1, 0.5]");
    EXPECT_EQ(invalid([] { Conduction<2>({{1, 1, 0}}, 0); }), "conduction: length 0 m of the grains is not positive");

    const auto network = [](auto&& spoil)
    {
        Network n;
        n.walls = {{0, 300.0}};
        n.add(300);
        n.add(310);
        n.join(0, 1, 1);
        double dt = 1;
        spoil(n, dt);
        return invalid([&] { n.advance(dt); });
    };
    EXPECT_EQ(network([](Network&, double& dt) { dt = 0; }), "conduction: time step 0 s is not positive");
    EXPECT_EQ(network([](Network& n, double&) { n.capacity.pop_back(); }),
              "conduction: 2 grains but 1 heat capacities");
    EXPECT_EQ(network([](Network& n, double&) { n.capacity[1] = 0; }),
              "conduction: grain 1: heat capacity 0 J/K is not positive");
    EXPECT_EQ(network([](Network& n, double&) { n.grains.temperature[0] = -3; }),
              "conduction: grain 0: temperature -3 K is not positive");
    EXPECT_EQ(network([](Network& n, double&) { n.walls[0].temperature = -3; }),
              "conduction: wall 0: temperature -3 K is not positive");
    EXPECT_EQ(network([](Network& n, double&) { n.grains.material[1] = 1; }),
              "conduction: grain 1: material 1 is not one of 1");
    EXPECT_EQ(network([](Network& n, double&) { n.walls[0].material = 4; }),
              "conduction: wall 0: material 4 is not one of 1");
    EXPECT_EQ(network([](Network& n, double&) { n.join(2, 1, 1); }), "conduction: contact 1: grain 2 is not one of 2");
    EXPECT_EQ(network([](Network& n, double&) { n.join(0, 2, 1); }), "conduction: contact 1: grain 2 is not one of 2");
    EXPECT_EQ(network([](Network& n, double&) { n.join(0, ~1, 1); }), "conduction: contact 1: wall 1 is not one of 1");
}

namespace
{

const nscd::ThermalMaterial glass{1, 7e10, 0.22, 2500 * 800.0};

/// Heat per degree [J/K] that passes between a ball of unit radius and a floor it meets at 1 m/s, in 2 s.
template <int D>
double passedInBounce(double restitution, double dt, double maxDisplacement = 0.5)
{
    Scene<D> scene(0);
    scene.add(up<D>(1.7003), up<D>(-1), 1, 100);
    scene.addFloor();
    scene.table.set(0, 1, {0, restitution});
    scene.settings.maxDisplacement = maxDisplacement;
    auto dynamics = scene.dynamics();
    dynamics.recordTouching(true);
    const nscd::Conduction<D> conduction({glass, glass}, 1);
    double passed = 0;
    for (int i = 0; i < std::lround(2 / dt); ++i)
    {
        fall<D>(dynamics, nscd::Vector<D>::Zero(), dt);
        nscd::Grains<D> grains = dynamics.grains();
        grains.temperature.assign(1, 300);
        const auto network = conduction.network(grains, {1.0}, dynamics.touching(), {{1, 400}}, dt);
        for (const nscd::HeatNetwork::Outlet& outlet : network.outlets())
        {
            passed += outlet.conductance * dt;
        }
    }
    return passed;
}

}  // namespace

TEST(Impact, ConductsByItsOwnTimeWhateverTheStep)
{
    const double wall = std::numeric_limits<double>::infinity();
    for (const double e : {0.3, 0.97})
    {
        const ThermalContact contact{glass, glass, 1, wall, 0, 1};
        const double spheres =
            nscd::impactOfSpheres(contact, 100, (1 + e) * 100, nscd::conductance::spheres).conducted;
        const double discs = nscd::impactOfCylinders(contact, 100, (1 + e) * 100, nscd::conductance::strip).conducted;
        for (const double dt : {0.2, 0.02, 0.003})
        {
            EXPECT_NEAR(passedInBounce<3>(e, dt) / spheres, 1, 1e-9) << e << ' ' << dt;
            EXPECT_NEAR(passedInBounce<2>(e, dt) / discs, 1, 1e-9) << e << ' ' << dt;
        }
        EXPECT_NEAR(passedInBounce<3>(e, 0.2, 0.02) / spheres, 1, 1e-9) << "sub-steps " << e;
    }
}

TEST(Impact, OfSpheresLastsAsHertzSaysAndWarmsWhatIsColdYet)
{
    // Glass on glass of 8 mm at 1 m/s: 2.87 (m^2/(R E^2 v))^(1/5), and 0.87 A t^(1/2) of both effusivities in series
    const double R = 2e-3, m = 2500 * M_PI / 6 * 5.12e-7 / 2, E = 7e10 / (2 * (1 - 0.22 * 0.22));
    const double time = 2.87 * std::pow(m * m / (R * E * E), 0.2);
    const ThermalContact contact{glass, glass, 4e-3, 4e-3, 0, 1};
    const nscd::ThermalImpact impact = nscd::impactOfSpheres(contact, m, 2 * m, nscd::conductance::spheres);
    EXPECT_NEAR(impact.time / time, 1, 1e-12);
    EXPECT_NEAR(impact.time, 2e-5, 1e-5);
    const double area = M_PI * R * time / 2.943;
    const double transient = 0.871 * area * std::sqrt(time) * std::sqrt(2e6) / 2;
    const double steady = impact.conducted - transient;
    EXPECT_GT(steady, 0);
    EXPECT_LT(steady, 0.1 * transient);   // Fourier number (k/(rho c)) t/a^2 of 1e-3
}

TEST(Contact, ThatLastsConductsTheSameInSubSteps)
{
    for (const double fine : {0.5, 1e-4})
    {
        Scene<3> scene(0);
        scene.add(up<3>(1), Vector<3>::Zero(), 1, 100);
        scene.add({10, 0, 1}, {1, 0, 0}, 1, 100);   // makes the sub-steps
        scene.addFloor();
        scene.settings.maxDisplacement = fine;
        auto dynamics = scene.dynamics();
        dynamics.recordTouching(true);
        const double dt = 1e-3;
        EXPECT_EQ(fall<3>(dynamics, up<3>(-g), dt).subSteps > 1, fine < 0.5);
        nscd::Grains<3> grains = dynamics.grains();
        grains.temperature.assign(2, 300);
        const Conduction<3> conduction({glass, glass}, 1);
        const auto network = conduction.network(grains, {1.0, 1.0}, dynamics.touching(), {{1, 400}}, dt);
        double first = 0;
        for (const nscd::HeatNetwork::Outlet& outlet : network.outlets())
        {
            first += outlet.i == 0 ? outlet.conductance : 0;
        }
        const double wall = std::numeric_limits<double>::infinity();
        EXPECT_NEAR(first / nscd::conductance::spheres({glass, glass, 1, wall, 100 * g, 1}), 1, 1e-9);
    }
}
