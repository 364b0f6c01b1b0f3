/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "contactLaw.H"

using namespace Foam;

namespace
{

nscd::ContactParameters law(const std::string& entries)
{
    return contactLaw::New(foamTest::dict("materials (a b); " + entries))->parameters();
}

}


TEST(ContactLaw, CoulombIsInelasticAndRollsFreelyByDefault)
{
    const nscd::ContactParameters p(law("type Coulomb; friction 0.3;"));
    EXPECT_EQ(p.friction, 0.3);
    EXPECT_EQ(p.restitution, 0);
    EXPECT_EQ(p.rolling, 0);
    EXPECT_EQ(p.cohesion, 0);
    EXPECT_EQ(p.tension, 0);
    EXPECT_EQ(p.cohesionDelay, 0);
}


TEST(ContactLaw, ReadsAllEntries)
{
    const nscd::ContactParameters p
    (
        law
        (
            "type cohesive; friction 0.3; restitution 0.5; rolling 0.01;"
            "cohesion [1 1 -2 0 0 0 0] 2e-3; tension [1 0 -2 0 0 0 0] 0.2; cohesionDelay 0.1;"
        )
    );
    EXPECT_EQ(p.friction, 0.3);
    EXPECT_EQ(p.restitution, 0.5);
    EXPECT_EQ(p.rolling, 0.01);
    EXPECT_EQ(p.cohesion, 2e-3);
    EXPECT_EQ(p.tension, 0.2);
    EXPECT_EQ(p.cohesionDelay, 0.1);
}


TEST(ContactLaw, RefusesWhatMakesNoSense)
{
    EXPECT_FOAM_ERROR(law("type Coulomb;"), "friction");
    EXPECT_FOAM_ERROR(law("type Hertz; friction 0.3;"), "Coulomb cohesive");
    EXPECT_FOAM_ERROR(law("type Coulomb; friction -1;"), "a value >= 0");
    EXPECT_FOAM_ERROR
    (
        law("type Coulomb; friction 0; restitution 1.1;"), "a value from 0 to 1"
    );
    EXPECT_FOAM_ERROR(law("type Coulomb; friction 0; rolling -1;"), "'rolling'");
    EXPECT_FOAM_ERROR(law("type Coulomb; friction 0; cohesion 1;"), "Unknown keyword 'cohesion'");
    EXPECT_FOAM_ERROR(law("type cohesive; friction 0; cohesion -1;"), "'cohesion'");
    EXPECT_FOAM_ERROR(law("type cohesive; friction 0; tension -1;"), "'tension'");
    EXPECT_FOAM_ERROR(law("type cohesive; friction 0; cohesionDelay -1;"), "'cohesionDelay'");
    EXPECT_FOAM_ERROR
    (
        law("type cohesive; friction 0; cohesion [1 0 0 0 0 0 0] 1;"), "'cohesion'"
    );
}
