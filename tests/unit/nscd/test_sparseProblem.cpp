// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The block-sparse contact problem and its residual.

#include "nscd/problem/SparseProblem.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using Problem = nscd::SparseProblem<2>;
using Entries = std::vector<Problem::Entry>;
using nscd::Vector;
using nscd::Vectors;

const Entries unit{{0, 0, 1}, {1, 1, 1}};

/// One contact with W = 1.
Problem single(const Vector<2>& q, double friction)
{
    return {{q}, {friction}, unit};
}

std::string refusal(Vectors<2> q, std::vector<double> friction, const Entries& entries)
{
    try
    {
        Problem(std::move(q), std::move(friction), entries);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "";
}

TEST(SparseProblem, IsTheSumOfItsEntriesInAnyOrder)
{
    const Problem p({{1, 2}, {3, 4}}, {0, 0.5},
                    {{3, 0, 5}, {2, 2, 1}, {0, 0, 2}, {0, 3, 7}, {1, 1, 1}, {0, 0, 3}, {3, 3, 1}});
    EXPECT_EQ(p.contacts(), 2);
    EXPECT_EQ(p.blocks(), 4u);
    EXPECT_EQ(p.own(0), (nscd::Block<2>() << 5, 0, 0, 1).finished());
    const Vectors<2> r{{1, 10}, {100, 1000}};
    EXPECT_EQ(p.velocity(0, r), Vector<2>(1 + 5 * 1 + 7 * 1000, 2 + 10));
    EXPECT_EQ(p.velocities(r)[1], Vector<2>(3 + 100, 4 + 5 * 1 + 1000));
}

TEST(SparseProblem, RefusesWhatIsNoProblemAndNamesTheContact)
{
    const double endless = std::numeric_limits<double>::infinity();
    const Vectors<2> q{{0, 0}, {0, 0}};
    const std::vector<double> friction{0.1, 0.2};
    const Entries good{{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {3, 3, 1}};
    EXPECT_EQ(refusal(q, friction, good), "");
    EXPECT_EQ(refusal(q, {0.1}, good), "1 coefficients of friction for 2 contacts");
    EXPECT_EQ(refusal(q, {0.1, -1}, good), "contact 1: the coefficient of friction -1 is not 0 or more");
    EXPECT_EQ(refusal({{0, 0}, {0, endless}}, friction, good), "contact 1: q is not finite");
    EXPECT_EQ(refusal(q, friction, unit), "contact 1: W_NN is not positive");
    EXPECT_EQ(refusal(q, friction, {{0, 0, -1}, {2, 2, 1}}), "contact 0: W_NN is not positive");
    EXPECT_EQ(refusal(q, friction, {{0, 0, 1}, {2, 0, 1}}), "contact 1: W_NN is not positive");
    EXPECT_EQ(refusal(q, friction, {{0, 0, endless}}), "contact 0: W is not finite");
    EXPECT_EQ(refusal(q, friction, {{0, 4, 1}}), "an entry in row 0 and column 4 of W, which is 4 x 4");
    EXPECT_EQ(refusal(q, friction, {{-1, 0, 1}}), "an entry in row -1 and column 0 of W, which is 4 x 4");
}

TEST(SparseResidual, OfSolutionsIsZero)
{
    // Separating, resting, sticking, sliding
    EXPECT_EQ(residual(single({1, 5}, 0.5), {{0, 0}}).worst, 0);
    EXPECT_EQ(residual(single({-1, 0}, 0.5), {{1, 0}}).worst, 0);
    EXPECT_EQ(residual(single({-1, 0.25}, 0.5), {{1, -0.25}}).worst, 0);
    EXPECT_NEAR(residual(single({-1, 3}, 0.5), {{1, -0.5}}).worst, 0, 1e-15);
}

TEST(SparseResidual, IsTheDistanceFromTheSolutionWhereWIsUnity)
{
    const Problem approaching = single({-2, 0}, 0.5);
    const nscd::Residual none = residual(approaching, {{0, 0}});
    EXPECT_EQ(none.worst, 2);
    EXPECT_EQ(none.relative, 1);
    EXPECT_EQ(none.penetration, 2);
    // An impulse that pulls
    EXPECT_EQ(residual(single({1, 0}, 0.5), {{-0.5, 0}}).worst, 0.5);
    // Too large
    EXPECT_EQ(residual(approaching, {{3, 0}}).worst, 1);
    EXPECT_EQ(residual(approaching, {{3, 0}}).penetration, 0);
}

TEST(SparseResidual, ProjectsOnTheConeAtRightAngles)
{
    // u = (0, 1), mu = 1: W_NN r - (mu |u_T|, u_T) = (2 - 1, -2) goes to the cone's side at (1.5, -1.5)
    const Problem p = single({-2, 2}, 1);
    const Vector<2> e(2 - 1.5, -1 + 1.5);
    EXPECT_NEAR(residual(p, {{2, -1}}).worst, e.norm(), 1e-15);
}

TEST(SparseResidual, HasUnitsOfVelocity)
{
    for (const double mass : {1e-6, 1.0, 1e6})
    {
        const Problem p({{-1, 0.2}}, {0.3}, {{0, 0, 1 / mass}, {1, 1, 3 / mass}});
        EXPECT_NEAR(residual(p, {{0.5 * mass, 0}}).worst, residual(single({-1, 0.2}, 0.3), {{0.5, 0}}).worst, 1e-15);
    }
}

TEST(SparseResidual, TakesTheWorstAndTheMeanOfContacts)
{
    const Problem p({{-1, 0}, {-7, 0}}, {0, 0}, {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {3, 3, 1}});
    const nscd::Residual r = residual(p, {{0, 0}, {4, 0}});
    EXPECT_EQ(r.worst, 3);
    EXPECT_NEAR(r.relative, std::sqrt((1 + 9) / (1.0 + 49)), 1e-15);
    EXPECT_EQ(r.penetration, 3);
}

}  // namespace
