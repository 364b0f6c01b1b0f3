/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "DallavalleDiFelice.H"
#include "settling.H"

using namespace Foam;

typedef dragLaws::DallavalleDiFelice Law;

namespace
{

const scalar d = 0.002, rho = 1200, mu = 0.05;

// gamma d^2/mu at a superficial Reynolds number
scalar coefficient(const scalar shape, const scalar eps, const scalar Re)
{
    const scalar w = Re*mu/(eps*rho*d);
    return Law::gamma(shape, eps, w, d, rho, mu)*sqr(d)/mu;
}

}


TEST(DallavalleDiFelice, HasTheLimitsOfCreepingFlow)
{
    // 3/4 and 2/pi of 4.8^2
    EXPECT_NEAR(coefficient(Law::sphere, 1, 0), 17.28, 1e-12);
    EXPECT_NEAR(coefficient(Law::disc, 1, 0), 14.667719555349075, 1e-12);
}


TEST(DallavalleDiFelice, HasTheLimitOfNewton)
{
    // (0.63 sqrt(Re))^2 outweighs the rest by 2*4.8/0.63/sqrt(Re)
    const scalar Re = 1e12;
    EXPECT_NEAR(coefficient(Law::sphere, 1, Re)/(0.75*sqr(0.63)*Re), 1, 2e-5);
}


TEST(DallavalleDiFelice, HasTheVoidageFunctionOfDiFelice)
{
    // Away from the dip eps^-2.8, in the middle of it, at log10 Re = 1.5, eps^-2.15
    EXPECT_NEAR
    (
        coefficient(Law::disc, 0.5, 0)/coefficient(Law::disc, 1, 0),
        std::pow(0.5, -2.8), 1e-12
    );
    const scalar Re = std::pow(10, 1.5);
    EXPECT_NEAR
    (
        coefficient(Law::disc, 0.5, Re)/coefficient(Law::disc, 1, Re),
        std::pow(0.5, -2.15), 1e-12
    );
}


TEST(DallavalleDiFelice, IsCloseToErgunInAFixedBed)
{
    // Pressure gradient of spheres at eps = 0.4 over that of Ergun's equation, which is within
    // 7 % of it from creeping flow to Re = 1000; tabulated with two decimals
    const scalar eps = 0.4, phi = 0.6;
    const std::vector<std::pair<scalar, scalar>> table
    {
        {1e-3, 1.01}, {1, 1.03}, {10, 0.99}, {31.6, 1.03}, {100, 1.07}, {1000, 1.07}
    };
    for (const auto& [Re, ratio] : table)
    {
        const scalar bed = phi*coefficient(Law::sphere, eps, Re)/sqr(eps);
        const scalar ergun = (150*sqr(phi) + 1.75*phi*Re)/pow3(eps);
        EXPECT_NEAR(bed/ergun, ratio, 0.005) << "Re = " << Re;
    }
}


TEST(DallavalleDiFelice, DependsOnTheReynoldsNumberAlone)
{
    // Ten times the size and a tenth of the speed
    EXPECT_NEAR
    (
        Law::gamma(Law::disc, 0.7, 0.3, d, rho, mu)*sqr(d),
        Law::gamma(Law::disc, 0.7, 0.03, 10*d, rho, mu)*sqr(10*d), 1e-12
    );
}


TEST(DallavalleDiFelice, IsFiniteAtRest)
{
    for (const scalar eps : {1.0, 0.4, 1e-8})
    {
        EXPECT_TRUE(std::isfinite(Law::gamma(Law::disc, eps, 0, d, rho, mu)));
    }
}


TEST(DragLaw, IsSelectedByName)
{
    const dictionary dict
    (
        foamTest::dict("type DallavalleDiFelice; shape sphere;")
    );
    EXPECT_EQ
    (
        dragLaw::New(dict, 3)->gamma(0.6, 0.1, d, rho, mu),
        Law::gamma(Law::sphere, 0.6, 0.1, d, rho, mu)
    );
    EXPECT_FOAM_ERROR(dragLaw::New(foamTest::dict("type Stoke;"), 3), "DallavalleDiFelice");
    EXPECT_FOAM_ERROR
    (
        dragLaw::New(foamTest::dict("type DallavalleDiFelice; shape cube;"), 2), "disc sphere"
    );
}


TEST(DragLaw, OfDiscsIsForTwoDimensions)
{
    const dictionary disc(foamTest::dict("type DallavalleDiFelice; shape disc;"));
    EXPECT_NO_THROW(dragLaw::New(disc, 2));
    EXPECT_FOAM_ERROR(dragLaw::New(disc, 3), "allowed: sphere");
}


TEST(DragLaw, IsByDefaultOfTheShapeOfTheGrains)
{
    const auto gamma = [](const char* shape, const label nDimensions)
    {
        const dictionary dict(foamTest::dict(std::string("type DallavalleDiFelice; ") + shape));
        return dragLaw::New(dict, nDimensions)->gamma(0.6, 0.1, d, rho, mu);
    };
    EXPECT_EQ(gamma("", 2), gamma("shape disc;", 2));
    EXPECT_EQ(gamma("", 3), gamma("shape sphere;", 3));
    EXPECT_NE(gamma("", 2), gamma("", 3));
    EXPECT_EQ(gamma("shape sphere;", 2), gamma("shape sphere;", 3));
}


TEST(DragLaw, OfSpheresIsForDiscsOnlyIfAskedFor)
{
    for (const char* law : {"Beetstra", "DiFelice", "ErgunWenYu", "KochHill", "Rong",
        "SchillerNaumann", "Stokes", "thesisPrinted"})
    {
        const std::string type(std::string("type ") + law + "; ");
        const auto make = [&](const char* shape, const label nDimensions)
        {
            return dragLaw::New(foamTest::dict(type + shape), nDimensions);
        };
        EXPECT_NO_THROW(make("", 3));
        EXPECT_NO_THROW(make("shape sphere;", 3));
        EXPECT_NO_THROW(make("shape sphere;", 2));
        EXPECT_FOAM_ERROR(make("", 2), std::string("'type' has the value ") + law);
        EXPECT_FOAM_ERROR(make("", 2), "shape sphere;");
        EXPECT_FOAM_ERROR(make("shape disc;", 2), law);
        EXPECT_FOAM_ERROR(make("shape disc;", 3), "'shape' has the value disc");
    }
}


TEST(SettlingSpeed, BalancesDragAndReducedWeight)
{
    const dictionary dict(foamTest::dict("type DallavalleDiFelice; shape disc;"));
    const autoPtr<dragLaw> drag(dragLaw::New(dict, 2));
    const scalar w = settlingSpeed(*drag, d, 2500, rho, mu, 9.81);
    EXPECT_NEAR(drag->gamma(1, w, d, rho, mu)*w, 1300*9.81, 1e-9*1300*9.81);
}
