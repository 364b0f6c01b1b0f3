/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "mathematicalConstants.H"
#include "SaffmanMei.H"

using namespace Foam;

typedef liftLaws::SaffmanMei Mei;

namespace
{

const scalar d = 1e-3, rho = 1000, mu = 1e-3;

// Force on a sphere [N]
vector lift(const char* type, const vector& w, const vector& vorticity, const vector& spin)
{
    const autoPtr<liftLaw> law =
        liftLaw::New(foamTest::dict(std::string("type ") + type + ";"));
    return constant::mathematical::pi/6*pow3(d)*law->force(w, vorticity, spin, d, rho, mu);
}

}


TEST(SaffmanMei, HasSaffmansForceInCreepingFlow)
{
    // 1.615 rho^1/2 mu^1/2 d^2 w G^1/2; a sphere that lags goes to where the fluid is faster:
    // u = (G y, 0, 0) has the vorticity (0, 0, -G)
    const scalar w = 1e-9, G = 1e-4;
    const vector f(lift("SaffmanMei", {w, 0, 0}, {0, 0, -G}, Zero));
    // Mei's correction at Re = 1e-6 is 1 - 0.1 Re (1 - 0.3314 beta^1/2), beta = 50
    const scalar saffman = 1.615*std::sqrt(rho*mu*G)*sqr(d)*w;
    EXPECT_NEAR(f.y()/saffman, 1, 1e-6);
    EXPECT_EQ(f.x(), 0);
    EXPECT_EQ(f.z(), 0);
    EXPECT_NEAR(lift("SaffmanMei", {-w, 0, 0}, {0, 0, -G}, Zero).y()/saffman, -1, 1e-6);
}


TEST(SaffmanMei, HasMeisCorrection)
{
    // By hand: Re = 10, beta = 0.1: 0.3314 0.316228 = 0.104798, e^-1 = 0.367879
    EXPECT_NEAR(Mei::correction(10, 0.1), 0.4341236, 1e-6);
    EXPECT_NEAR(Mei::correction(100, 0.1), 0.1657034, 1e-6);
    EXPECT_EQ(Mei::correction(0, 0.1), 1);
    // The two branches meet at Re = 40 but for e^-4
    EXPECT_NEAR(Mei::correction(40, 0.1), Mei::correction(40*(1 + 1e-12), 0.1), 0.02);
}


TEST(SaffmanMei, IsNothingWithoutShearOrSlip)
{
    EXPECT_EQ(lift("SaffmanMei", {1, 0, 0}, Zero, Zero), vector(Zero));
    EXPECT_EQ(lift("SaffmanMei", Zero, {0, 0, 1}, Zero), vector(Zero));
    EXPECT_EQ(lift("SaffmanMei", {0, 0, 1}, {0, 0, 1}, Zero), vector(Zero));
}


TEST(Magnus, IsTheForceOfRubinowAndKeller)
{
    // pi a^3 rho Omega x V, V the velocity of the sphere in fluid at rest
    const vector V(0.2, 0, 0), spin(0, 0, 30);
    const vector f(lift("Magnus", -V, Zero, spin));
    const vector exact(constant::mathematical::pi*pow3(d/2)*rho*(spin ^ V));
    EXPECT_NEAR(mag(f - exact)/mag(exact), 0, 1e-14);
    EXPECT_GT(f.y(), 0);
}


TEST(Magnus, IsNothingForASphereThatTurnsWithTheFluid)
{
    EXPECT_EQ(lift("Magnus", {1, 2, 3}, {0, 4, 6}, {0, 2, 3}), vector(Zero));
}


TEST(LiftLaw, RefusesWhatItDoesNotKnow)
{
    const auto all = [](const char* text) { return liftLaw::all(foamTest::dict(text)).size(); };
    EXPECT_EQ(all(""), 0);
    EXPECT_EQ(all("lift { a { type Magnus; } b { type SaffmanMei; } }"), 2);
    EXPECT_FOAM_ERROR(all("lift { a { type Saffman; } }"), "(Magnus SaffmanMei)");
    EXPECT_FOAM_ERROR(all("lift { a { type Magnus; coefficient 1; } }"), "'coefficient'");
    EXPECT_FOAM_ERROR(all("lift { type Magnus; }"), "'type'");
}


TEST(LiftLaw, OfSpheresIsForDiscsOnlyIfAskedFor)
{
    const auto all = [](const char* shape, const char* lift)
    {
        const dictionary grains
        (
            foamTest::dict
            (
                std::string("shape ") + shape + "; coupling { lift { a { " + lift + " } } }"
            )
        );
        return liftLaw::all(grains.subDict("coupling")).size();
    };
    for (const char* law : {"type Magnus;", "type SaffmanMei;"})
    {
        EXPECT_EQ(all("sphere", law), 1);
        EXPECT_EQ(all("disc", (std::string(law) + " shape sphere;").c_str()), 1);
        EXPECT_FOAM_ERROR(all("disc", law), "shape sphere;");
        EXPECT_FOAM_ERROR(all("sphere", (std::string(law) + " shape disc;").c_str()), "'shape'");
    }
}
