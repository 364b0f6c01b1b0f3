/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "mathematicalConstants.H"
#include "prescribedMotion.H"
#include "wallMotion.H"

using namespace Foam;

namespace
{

const double dt = 0.01;

// A wall without grains in steps of dt
class WallMotion
:
    public ::testing::Test
{
protected:

    foamTest::planarCase planar_{1, 1};
    grainSpace<2> space_{planar_.mesh()};

    autoPtr<wallMotion<2>> motion(const std::string& entries)
    {
        return wallMotion<2>::New(foamTest::dict(entries), space_);
    }

    // The body after n steps, in gravity
    nscd::WallBody<2> after(const int n, const std::string& entries)
    {
        const autoPtr<wallMotion<2>> m(motion(entries));
        nscd::Segment wall;
        wall.a = {0, 0};
        wall.b = {1, 0};
        wall.body = 0;
        nscd::ContactDynamics<2> dynamics
        (
            nscd::Grains<2>(), {wall}, nscd::ContactTable(1), nscd::Settings(),
            MPI_COMM_SELF, {m->body()}
        );
        for (int i = 0; i < n; ++i)
        {
            m->set(dynamics, 0, i*dt, dt, {0, -9.81});
            dynamics.step({}, {}, dt);
        }
        return dynamics.wallBodies()[0];
    }
};

}


TEST_F(WallMotion, IsAtATimeWhereItsStepsLead)
{
    for (const char* entries :
        {
            "type translation; velocity (1 2 0); start 0.023; end 0.071;",
            "type oscillation; direction (1 1 0); amplitude 0.3; frequency 4;",
            "type rotation; origin (0.2 0.1 0); axis (0 0 1); rpm 30; start 0.015;",
            "type table; displacement table ((0 (0 0 0)) (0.04 (1 0 0)) (1 (3 2 0)));"
            " angle table ((0 0) (0.03 1) (1 2)); origin (0.5 0.5 0); axis (0 0 1);"
        })
    {
        const autoPtr<wallMotion<2>> m(motion(entries));
        const auto& prescribed = dynamic_cast<const wallMotions::prescribed<2>&>(*m);
        const nscd::WallBody<2> at = prescribed.bodyAt(10*dt);
        const nscd::WallBody<2> led = after(10, entries);
        EXPECT_NEAR((at.position - led.position).norm(), 0, 1e-14) << entries;
        EXPECT_NEAR(at.orientation.angle(), led.orientation.angle(), 1e-14) << entries;
    }
}


TEST_F(WallMotion, TranslatesBetweenTwoTimes)
{
    EXPECT_NEAR(after(10, "type translation; velocity (0 2 0);").position.y(), 0.2, 1e-14);

    // Start and end within a step
    const std::string entries("type translation; velocity (1 0 0); start 0.025; end 0.064;");
    EXPECT_EQ(after(2, entries).position.x(), 0);
    EXPECT_NEAR(after(3, entries).position.x(), 0.005, 1e-15);
    EXPECT_NEAR(after(9, entries).position.x(), 0.039, 1e-15);
}


TEST_F(WallMotion, RotatesAboutItsAxis)
{
    const std::string entries("type rotation; origin (1 2 0); axis (0 0 3);");
    const nscd::WallBody<2> body(after(25, entries + "rpm 60;"));
    EXPECT_NEAR(body.orientation.angle(), constant::mathematical::pi/2, 1e-13);
    EXPECT_EQ(body.position, nscd::Vector<2>(1, 2));
    EXPECT_NEAR(after(25, entries + "omega -2;").orientation.angle(), -0.5, 1e-14);
}


TEST_F(WallMotion, OscillatesExactlyAtTheEndsOfSteps)
{
    const std::string entries
    (
        "type oscillation; direction (0 2 0); amplitude 0.003; frequency 7; start 0.02;"
    );
    for (const int n : {1, 2, 3, 10, 50})
    {
        const double exact =
            0.003*std::sin(constant::mathematical::twoPi*7*std::max(n*dt - 0.02, 0.0));
        EXPECT_NEAR(after(n, entries).position.y(), exact, 1e-15) << n;
    }
}


TEST_F(WallMotion, FollowsTables)
{
    const std::string displacement
    (
        "displacement table ((0 (0 0 0)) (0.1 (0.2 0 0)) (1 (0.2 1 0)));"
    );
    EXPECT_NEAR(after(5, "type table;" + displacement).position.x(), 0.1, 1e-14);
    const nscd::WallBody<2> body
    (
        after
        (
            28, "type table; origin (0 0 0); axis (0 0 -1);"
            "angle table ((0 0) (1 1));" + displacement
        )
    );
    EXPECT_NEAR(body.position.y(), 0.2, 1e-14);
    EXPECT_NEAR(body.orientation.angle(), -0.28, 1e-14);
}


TEST_F(WallMotion, FreeFallsUnderWeightAndForce)
{
    const nscd::WallBody<2> body
    (
        after(10, "type free; mass 2; centre (0 1 0); force (4 0 0); velocity (0 1 0);")
    );
    EXPECT_NEAR(body.velocity.x(), 0.2, 1e-14);
    EXPECT_NEAR(body.velocity.y(), 1 - 0.981, 1e-14);
    EXPECT_NEAR(body.position.y(), 1 + 0.1 - 9.81*dt*dt*55, 1e-13);
    EXPECT_TRUE(std::isinf(motion("type free; mass 1; centre (0 0 0);")->body().inertia[0]));
    EXPECT_EQ
    (
        motion("type free; mass 1; centre (0 0 0); inertia (1 2 3);")->body().inertia[0], 3
    );
}


TEST_F(WallMotion, RefusesWhatMakesNoSense)
{
    EXPECT_FOAM_ERROR
    (
        motion("type jump;"), "free mesh oscillation rotation table translation"
    );
    EXPECT_FOAM_ERROR(motion("type translation;"), "velocity");
    EXPECT_FOAM_ERROR(motion("type translation; velocity (0 0 1);"), "in the plane of the mesh");
    EXPECT_FOAM_ERROR
    (
        motion("type translation; velocity (0 1 0); start 1; end 0;"), "'end'"
    );
    EXPECT_FOAM_ERROR
    (
        motion("type rotation; origin (0 0 0); axis (1 0 0); rpm 1;"), "normal to the plane"
    );
    EXPECT_FOAM_ERROR(motion("type rotation; origin (0 0 0); axis (0 0 1);"), "omega");
    EXPECT_FOAM_ERROR
    (
        motion("type rotation; origin (0 0 0); axis (0 0 1); rpm 1; omega 1;"), "one of"
    );
    EXPECT_FOAM_ERROR
    (
        motion("type oscillation; direction (0 1 0); amplitude 1; frequency 0;"), "'frequency'"
    );
    EXPECT_FOAM_ERROR(motion("type mesh;"), "is not 'patches'");
    EXPECT_FOAM_ERROR(motion("type free; centre (0 0 0);"), "mass");
    EXPECT_FOAM_ERROR(motion("type free; mass -1; centre (0 0 0);"), "'mass'");
    EXPECT_FOAM_ERROR
    (
        motion("type free; mass 1; centre (0 0 0); inertia (1 0 1);"), "three values > 0"
    );
}
