// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole contact problems by every solver: statics with exact answers, piles, problems without a solution.

#include "Bodies.hpp"
#include "Scene.hpp"
#include "nscd/packing/Packing.hpp"
#include "nscd/problem/SparseSolve.hpp"

#include <gtest/gtest.h>

namespace
{

using nscd::Vector;

constexpr double weight = 9.81e-3;  // m g dt of a unit mass [N s]
const nscd::SolveLimits tight{1e-13, 200000};

class SparseSolve : public testing::TestWithParam<const char*>
{
protected:
    template <int D>
    nscd::SparseSolution<D> solve(const nscd::SparseProblem<D>& problem, const nscd::SolveLimits& limits = tight,
                                  nscd::Vectors<D> guess = {}) const
    {
        return nscd::solve<D>(problem, nscd::solverOfName(GetParam()), limits, std::move(guess));
    }
};

INSTANTIATE_TEST_SUITE_P(Solvers, SparseSolve, testing::Values("sweeps", "queue", "nesterov"),
                         [](const auto& parameter) { return std::string(parameter.param); });

/// A vertical column of unit grains on the ground under gravity.
template <int D>
Bodies<D> column(int grains)
{
    Bodies<D> b;
    for (int i = 1; i <= grains; ++i)
    {
        b.addGrain((2 * i - 1) * up<D>());
        i == 1 ? b.touchGround(1, Vector<D>::Zero(), 0.3) : b.touch(i - 1, i, 0.3);
    }
    b.accelerate(-weight * up<D>());
    return b;
}

template <int D>
void expectColumn(const nscd::SparseSolution<D>& s, int grains)
{
    EXPECT_TRUE(s.converged);
    for (int k = 0; k < grains; ++k)
    {
        EXPECT_NEAR(s.r[k][0], (grains - k) * weight, 1e-8 * weight) << "contact " << k;
        EXPECT_NEAR(s.r[k].template tail<D - 1>().norm(), 0, 1e-8 * weight);
    }
}

TEST_P(SparseSolve, ColumnCarriesWhatIsAboveEachContact)
{
    expectColumn<2>(solve(column<2>(10).problem()), 10);
    expectColumn<3>(solve(column<3>(10).problem()), 10);
}

/// Two discs on the ground that touch, and one on them.
Bodies<2> pyramid(double friction, double groundFriction)
{
    Bodies<2> b;
    b.addGrain({-1, 1});
    b.addGrain({1, 1});
    b.addGrain({0, 1 + std::sqrt(3.0)});
    b.touchGround(1, {-1, 0}, groundFriction);
    b.touchGround(2, {1, 0}, groundFriction);
    b.touch(1, 3, friction);
    b.touch(2, 3, friction);
    b.accelerate(-weight * up<2>());
    return b;
}

TEST_P(SparseSolve, PyramidStandsByEnoughFriction)
{
    // Moments about the lower discs' centres and forces: mu >= tan 15 deg between discs and
    // tan 15 deg/3 on the ground.  One per cent either way decides.
    const double critical = std::tan(M_PI / 12);
    const auto stands = solve(pyramid(1.01 * critical, 1.01 * critical / 3).problem());
    EXPECT_TRUE(stands.converged);
    EXPECT_NEAR(stands.r[0][0], 1.5 * weight, 1e-8 * weight);
    EXPECT_NEAR(stands.r[1][0], 1.5 * weight, 1e-8 * weight);
    EXPECT_NEAR(stands.r[2][0], 0.5 * weight, 1e-8 * weight);
    for (const auto& [mu, groundMu] : {std::pair(0.99, 1.01), std::pair(1.01, 0.99)})
    {
        const Bodies<2> b = pyramid(mu * critical, groundMu * critical / 3);
        const auto falls = solve(b.problem());
        EXPECT_TRUE(falls.converged);
        const auto moved = nscd::withImpulses<2>(b.bodies, b.contacts, falls.r);
        EXPECT_LT(moved[3].velocity.y(), -1e-4 * weight);
        EXPECT_NEAR(moved[1].velocity.x(), -moved[2].velocity.x(), 1e-10);
    }
}

TEST_P(SparseSolve, PyramidOfSpheresStandsByEnoughFriction)
{
    // The line of centres is inclined by acos(h/2); between spheres mu >= the tangent of half of it, on the ground,
    // which carries four times as much, a quarter
    const double height = std::sqrt(8.0 / 3);
    const double critical = std::tan(0.5 * std::acos(0.5 * height));
    const auto pile = [&](double mu, double groundMu)
    {
        Bodies<3> b;
        for (int i = 0; i < 3; ++i)
        {
            const double angle = 2 * M_PI * i / 3;
            const Vector<3> x = 2 / std::sqrt(3.0) * Vector<3>(std::cos(angle), std::sin(angle), 0);
            b.addGrain(x + Vector<3>(0, 0, 1));
            b.touchGround(i + 1, x, groundMu);
        }
        const int top = b.addGrain({0, 0, 1 + height});
        for (int i = 1; i <= 3; ++i)
        {
            b.touch(i, top, mu);
        }
        b.accelerate({0, 0, -weight});
        return b;
    };
    const auto stands = solve(pile(1.01 * critical, 1.01 * critical / 4).problem());
    EXPECT_TRUE(stands.converged);
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_NEAR(stands.r[i][0], 4.0 / 3 * weight, 1e-8 * weight);
        EXPECT_NEAR(stands.r[3 + i][0], weight / 3, 1e-8 * weight);
    }
    for (const auto& [mu, groundMu] : {std::pair(0.99, 1.01), std::pair(1.01, 0.99)})
    {
        const Bodies<3> b = pile(mu * critical, groundMu * critical / 4);
        const auto falls = solve(b.problem());
        EXPECT_TRUE(falls.converged);
        EXPECT_LT((nscd::withImpulses<3>(b.bodies, b.contacts, falls.r)[4].velocity.z()), -1e-4 * weight);
    }
}

/// A box, 2 b wide and 2 h high, on a plane inclined by 'angle' towards +x, that stands on its two lower corners.
Bodies<2> box(double b, double h, double angle, double friction)
{
    Bodies<2> scene;
    scene.bodies.push_back(Bodies<2>::body({0, h}, 1, 3 / (b * b + h * h)));
    scene.touchGround(1, {-b, 0}, friction);
    scene.touchGround(1, {b, 0}, friction);
    scene.accelerate(weight * Vector<2>(std::sin(angle), -std::cos(angle)));
    return scene;
}

TEST_P(SparseSolve, BoxOnAnInclineSlidesOrTopples)
{
    // Contacts beside the centre of mass couple normal and tangential directions, and W of two of them is singular
    const double mu = 0.5;
    const auto velocity = [&](double b, double h, double angle)
    {
        const Bodies<2> scene = box(b, h, angle, mu);
        const auto s = solve(scene.problem());
        EXPECT_TRUE(s.converged);
        return nscd::withImpulses<2>(scene.bodies, scene.contacts, s.r)[1];
    };
    for (const double angle : {0.1, 0.99 * std::atan(mu)})
    {
        const auto rests = velocity(2, 1, angle);
        EXPECT_LE(rests.velocity.norm() + std::abs(rests.spin[0]), 1e-10 * weight);
    }
    const double steep = 1.1 * std::atan(mu);
    const auto slides = velocity(2, 1, steep);
    EXPECT_NEAR(slides.velocity.x(), weight * (std::sin(steep) - mu * std::cos(steep)), 1e-10 * weight);
    EXPECT_NEAR(slides.spin[0], 0, 1e-10 * weight);
    // Topples about its lower corner, sticking, once tan(angle) > b/h
    const double b = 0.3, h = 1;
    EXPECT_NEAR(velocity(b, h, 0.99 * std::atan(b / h)).spin[0], 0, 1e-10 * weight);
    const double angle = 1.01 * std::atan(b / h);
    const auto topples = velocity(b, h, angle);
    const double spin = -weight * (h * std::sin(angle) - b * std::cos(angle)) / (4 * (b * b + h * h) / 3);
    EXPECT_NEAR(topples.spin[0], spin, 1e-10 * weight);
    EXPECT_NEAR(topples.velocity.x(), -spin * h, 1e-10 * weight);
}

/// Spheres that have settled in a box, and the contacts they may make in the next step of 0.5 ms.
Bodies<3> pile()
{
    constexpr double dt = 5e-4;
    const int perSide = 5;
    Scene<3> scene(0.3);
    scene.settings = nscd::Settings();
    nscd::Random random(1);
    for (int i = 0; i < 300; ++i)
    {
        const Vector<3> cell(i % perSide, i / perSide % perSide, i / perSide / perSide);
        const double r = 1.5e-3 * random.uniform(0.8, 1);
        const Vector<3> x = 3.1e-3 * (cell + Vector<3>::Constant(0.5));
        scene.add(x, {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0}, r, 2500 * 4 / 3.0 * M_PI * r * r * r);
    }
    scene.addBox({3.1e-3 * perSide, 3.1e-3 * perSide, 1});
    const auto settled = nscd::settle<3>(scene.dynamics(), {0, 0, -9.81}, dt, 1e-2, 1).grains;

    Bodies<3> b;
    for (std::size_t i = 0; i < settled.size(); ++i)
    {
        b.addGrain(settled.position[i], settled.radius[i], settled.mass[i]);
        b.bodies.back().velocity = settled.velocity[i];
        b.bodies.back().spin = settled.spin[i];
    }
    b.accelerate({0, 0, -9.81 * dt});
    const auto touch = [&](int i, int j, const Vector<3>& n, double gap)
    {
        if (gap < 1.5e-5)
        {
            b.contacts.push_back(
                {i, j, b.bodies[j].position - settled.radius[j - 1] * n, n, std::max(gap, 0.0) / dt, 0.3});
        }
    };
    for (std::size_t j = 0; j < settled.size(); ++j)
    {
        for (std::size_t i = 0; i < j; ++i)
        {
            const Vector<3> between = settled.position[j] - settled.position[i];
            touch(int(i) + 1, int(j) + 1, between.normalized(), between.norm() - settled.radius[i] - settled.radius[j]);
        }
        for (const auto& wall : scene.walls)
        {
            const auto& plane = std::get<nscd::Plane>(wall);
            touch(0, int(j) + 1, plane.normal,
                  (settled.position[j] - plane.point).dot(plane.normal) - settled.radius[j]);
        }
    }
    return b;
}

TEST(SparseSolvers, AgreeOnAPile)
{
    const nscd::SparseProblem<3> problem = pile().problem();
    EXPECT_GT(problem.contacts(), 700);
    const nscd::Residual start = residual(problem, nscd::Vectors<3>(problem.contacts(), Vector<3>::Zero()));
    const nscd::SolveLimits limits{1e-6 * start.worst, 100000};
    std::vector<nscd::Vectors<3>> u;
    for (const auto solver : {nscd::Solver::sweeps, nscd::Solver::queue, nscd::Solver::nesterov})
    {
        const auto s = nscd::solve<3>(problem, solver, limits);
        EXPECT_TRUE(s.converged);
        EXPECT_LE(s.residual.worst, limits.tolerance);
        EXPECT_EQ(s.residual.worst, residual(problem, s.r).worst);
        EXPECT_LE(s.residual.relative, 1e-5);
        EXPECT_GE(s.cpuSeconds, 0);
        u.push_back(problem.velocities(s.r));
    }
    for (int c = 0; c < problem.contacts(); ++c)
    {
        // Impulses of a pile are not unique, its velocities are here; errors add up along chains of a dozen grains
        EXPECT_LE((u[0][c] - u[1][c]).norm(), 100 * limits.tolerance);
        EXPECT_LE((u[0][c] - u[2][c]).norm(), 100 * limits.tolerance);
    }
}

TEST(SparseSolvers, MomentumSavesSweepsInADeepColumn)
{
    const nscd::SparseProblem<2> problem = column<2>(50).problem();
    const nscd::SolveLimits limits{1e-6 * weight, 200000};
    const auto plain = nscd::solve<2>(problem, nscd::Solver::sweeps, limits);
    const auto fast = nscd::solve<2>(problem, nscd::Solver::nesterov, limits);
    EXPECT_TRUE(plain.converged);
    EXPECT_TRUE(fast.converged);
    // Plain sweeps take some N^2, with momentum some N
    EXPECT_GT(plain.sweeps, 50 * 50);
    EXPECT_LT(fast.sweeps, 20 * 50);
}

TEST(SparseSolvers, QueueWorksOnlyWhereSomethingHappens)
{
    // A thousand columns of five at rest; one grain is hit
    Bodies<2> b;
    for (int k = 0; k < 1000; ++k)
    {
        for (int i = 0; i < 5; ++i)
        {
            const int grain = b.addGrain({3.0 * k, 1 + 2.0 * i});
            i == 0 ? b.touchGround(grain, {3.0 * k, 0}, 0.3) : b.touch(grain - 1, grain, 0.3);
        }
    }
    b.accelerate(-weight * up<2>());
    const nscd::SolveLimits limits{1e-9 * weight, 100000};
    const auto rest = nscd::solve<2>(b.problem(), nscd::Solver::queue, limits);
    EXPECT_TRUE(rest.converged);
    b.bodies[2503].velocity.y() -= weight;
    const auto hit = nscd::solve<2>(b.problem(), nscd::Solver::queue, limits, rest.r);
    const auto swept = nscd::solve<2>(b.problem(), nscd::Solver::sweeps, limits, rest.r);
    EXPECT_TRUE(hit.converged);
    // Five of five thousand contacts
    EXPECT_LE(hit.sweeps, 1.1e-3 * swept.sweeps);
}

TEST_P(SparseSolve, StartsFromTheGuess)
{
    const nscd::SparseProblem<2> problem = column<2>(10).problem();
    const auto first = solve(problem);
    const auto again = solve(problem, tight, first.r);
    EXPECT_EQ(again.sweeps, 0);
    EXPECT_TRUE(again.converged);
    EXPECT_EQ(again.r, first.r);
}

TEST_P(SparseSolve, GivesUpAfterTheAllowedWork)
{
    const nscd::SparseProblem<2> problem = column<2>(50).problem();
    for (const int sweeps : {0, 1, 7})
    {
        const auto s = solve(problem, {1e-13, sweeps});
        EXPECT_FALSE(s.converged);
        EXPECT_LE(s.sweeps, sweeps);
        EXPECT_EQ(s.residual.worst, residual(problem, s.r).worst);
    }
}

TEST_P(SparseSolve, EndsWhereThereIsNoSolution)
{
    // W of rank one: pressing does not stop the slip but raises the approach velocity
    const nscd::SparseProblem<2> jam({{-1, 1}}, {2}, {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}});
    EXPECT_FALSE(solve(jam, {1e-6, 1000000000}).converged);
    // Contacts that press each other apart more and more
    const nscd::SparseProblem<2> runaway({{-1, 0}, {-1, 0}}, {0, 0},
                                         {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {3, 3, 1}, {0, 2, -2}, {2, 0, -2}});
    const auto s = solve(runaway, {1e-6, 1000000000});
    EXPECT_FALSE(s.converged);
    EXPECT_LT(s.sweeps, 1000);
    EXPECT_EQ(s.residual.worst, residual(runaway, s.r).worst);
}

TEST_P(SparseSolve, LetsGoOfAGuessThatIsNotNeeded)
{
    // Nothing moves
    const nscd::SparseProblem<2> still({{0, 0}}, {0.3}, {{0, 0, 1}, {1, 1, 1}});
    const auto s = solve<2>(still, tight, {{5, -1}});
    EXPECT_TRUE(s.converged);
    EXPECT_EQ(s.residual.worst, 0);
    EXPECT_EQ(s.r[0].norm(), 0);
}

TEST_P(SparseSolve, OfNoContactsIsDone)
{
    const auto s = solve(nscd::SparseProblem<3>({}, {}, {}));
    EXPECT_TRUE(s.converged);
    EXPECT_EQ(s.sweeps, 0);
}

TEST_P(SparseSolve, RefusesSenselessLimitsAndGuesses)
{
    const nscd::SparseProblem<2> problem = column<2>(2).problem();
    EXPECT_THROW(solve(problem, {0, 10}), std::invalid_argument);
    EXPECT_THROW(solve(problem, {std::nan(""), 10}), std::invalid_argument);
    EXPECT_THROW(solve(problem, {1e-6, -1}), std::invalid_argument);
    EXPECT_THROW(solve<2>(problem, tight, {{0, 0}}), std::invalid_argument);
    EXPECT_THROW(solve<2>(problem, tight, {{0, 0}, {0, std::nan("")}}), std::invalid_argument);
}

TEST(SparseSolvers, AreKnownByName)
{
    EXPECT_EQ(nscd::solverOfName("queue"), nscd::Solver::queue);
    try
    {
        nscd::solverOfName("newton");
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_STREQ(error.what(), "unknown solver 'newton': sweeps, queue and nesterov are known");
    }
}

}  // namespace
