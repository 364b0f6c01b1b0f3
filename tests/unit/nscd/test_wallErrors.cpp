// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls and wall bodies that are refused, and in which words.

#include "Surfaces.hpp"

#include "nscd/dynamics/Validation.hpp"

#include <gtest/gtest.h>

namespace wallErrors
{

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
std::string refusal(const nscd::Walls<D>& walls, const std::vector<nscd::WallBody<D>>& bodies = {})
{
    try
    {
        nscd::validate<D>(walls, nscd::ContactTable(2), bodies);
        return "accepted";
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
}

std::string refusalOf(const Point& a, const Point& b, const Point& c)
{
    return refusal<3>({nscd::Triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, nscd::Triangle{a, b, c}});
}

std::string refusalOf(const nscd::WallBody<3>& body)
{
    return refusal<3>({}, {body});
}

/// A body that turns only when told to.
nscd::WallBody<3> body(const Point& spin = Point::Zero())
{
    nscd::WallBody<3> made;
    made.spin = spin;
    return made;
}

TEST(Triangles, WithoutAreaAreRefused)
{
    EXPECT_EQ(refusalOf({1, 2, 3}, {1, 2, 3}, {1, 2, 3}),
              "wall 1: the three corners of the triangle coincide at (1 2 3)");
    EXPECT_EQ(refusalOf({0, 0, 0}, {1, 0, 0}, {2, 0, 0}),
              "wall 1: the triangle has no area: it is 2 m long and 0 m high, in a surface that extends over 2 m");
    EXPECT_EQ(refusalOf({0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}),
              "wall 1: the triangle has no area: it is 1 m long and 1e-09 m high, in a surface that extends over 2 m");
    EXPECT_EQ(refusalOf({0, 0, 0}, {1, 0, 0}, {1, 1e-8, 0}), "accepted");
}

TEST(Triangles, ThatAreNotFiniteOrOfNoMaterialAreRefused)
{
    EXPECT_EQ(refusalOf({0, 0, 0}, {1, notANumber, 0}, {0, 1, 0}), "wall 1: a corner of the triangle is not finite");
    EXPECT_EQ(refusalOf({0, 0, 0}, {1, 0, 0}, {0, infinity, 0}), "wall 1: a corner of the triangle is not finite");
    EXPECT_EQ(refusal<3>({nscd::Triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 2}}),
              "wall 0: material 2 is not one of the 2 of the contact table");
}

TEST(WallsOfBodies, MustNameOneOfThem)
{
    EXPECT_EQ(refusal<3>({nscd::Triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0, 1}}, {body()}),
              "wall 0: body 1 is neither -1 (fixed) nor one of the 1 wall bodies");
    EXPECT_EQ(refusal<3>({nscd::Plane{{0, 0, 0}, {0, 0, 1}, 0, -2}}),
              "wall 0: body -2 is neither -1 (fixed) nor one of the 0 wall bodies");
    EXPECT_EQ(refusal<2>({{{0, 0}, {1, 0}, 0, 0}}),
              "wall 0: body 0 is neither -1 (fixed) nor one of the 0 wall bodies");
    EXPECT_EQ(refusal<2>({{{0, 0}, {1, 0}, 0, 0}}, {nscd::WallBody<2>()}), "accepted");
}

TEST(Planes, OnABodyThatMayTurnAreRefused)
{
    const nscd::Walls<3> walls{nscd::Triangle{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0, 0},
                               nscd::Plane{{0, 0, 0}, {0, 0, 1}, 0, 1}};
    const std::string refused = "wall 1: a plane cannot turn with its body 1; make it of triangles";
    EXPECT_EQ(refusal<3>(walls, {body({1, 0, 0}), body()}), "accepted");
    EXPECT_EQ(refusal<3>(walls, {body(), body({0, 1e-3, 0})}), refused);
    nscd::WallBody<3> piston = body();
    piston.mass = 2;
    EXPECT_EQ(refusal<3>(walls, {body(), piston}), "accepted");
    piston.inertia = {infinity, infinity, 1};
    EXPECT_EQ(refusal<3>(walls, {body(), piston}), refused);
    EXPECT_THROW(nscd::checkSpin<3>(walls, 1, {0, 0, 1}), std::invalid_argument);
    EXPECT_NO_THROW(nscd::checkSpin<3>(walls, 0, {0, 0, 1}));
}

TEST(WallBodies, WithSenselessValuesAreRefused)
{
    nscd::WallBody<3> bad = body();
    bad.position.x() = notANumber;
    EXPECT_EQ(refusalOf(bad), "wall body 0: position is not finite");
    bad = body();
    bad.velocity.x() = infinity;
    EXPECT_EQ(refusalOf(bad), "wall body 0: velocity is not finite");
    EXPECT_EQ(refusalOf(body({0, notANumber, 0})), "wall body 0: spin is not finite");
    bad = body();
    bad.force.x() = notANumber;
    EXPECT_EQ(refusalOf(bad), "wall body 0: force is not finite");
    bad = body();
    bad.torque.x() = notANumber;
    EXPECT_EQ(refusalOf(bad), "wall body 0: torque is not finite");
    bad = body();
    bad.mass = 0;
    EXPECT_EQ(refusalOf(bad), "wall body 0: mass is not positive");
    bad = body();
    bad.inertia.y() = notANumber;
    EXPECT_EQ(refusalOf(bad), "wall body 0: a moment of inertia is not positive");
    bad = body();
    bad.orientation.coeffs() *= 2;
    EXPECT_EQ(refusalOf(bad), "wall body 0: orientation is not a rotation");
}

TEST(Planes, AcrossAPeriodicBoxAreRefused)
{
    nscd::Settings settings;
    settings.period = {5, 0, 0};
    EXPECT_NO_THROW(nscd::validate<3>(settings, {nscd::Plane{{0, 0, 0}, {0, 0.6, 0.8}}}));
    try
    {
        nscd::validate<3>(settings, {nscd::Plane{{0, 0, 0}, {0, 0, 1}}, nscd::Plane{{0, 0, 0}, {-0.6, 0, 0.8}}});
        FAIL() << "accepted";
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_STREQ(error.what(),
                     "settings: period 5 m, but wall 1 is a plane across it, which has no periodic image; use "
                     "triangles");
    }
}

}  // namespace wallErrors
