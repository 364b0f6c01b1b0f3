/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "selfInducedVelocity.H"

#include <cmath>

using namespace Foam;

namespace
{

const scalar d = 0.002, rho = 1200, mu = 0.05;
const scalar volume = M_PI/6*pow3(d);

const selfInduced::neighbours alone{1, 0, 1};

autoPtr<dragLaw> law(const word& type)
{
    return dragLaw::New(foamTest::dict("type " + type + "; shape sphere;"), 3);
}

// 1 - lambda by a law of lone spheres
scalar seen(const word& type, const scalar Lambda, const scalar Re)
{
    const autoPtr<dragLaw> drag(law(type));
    const scalar slip = Re*mu/(rho*d);
    return 1/selfInduced::slipFactor({*drag, d, rho, mu}, volume, alone, Lambda, {0.3, 1}, slip);
}

}


TEST(DragLaw, HoldsTheFluidOfACoveredCellToTheGrain)
{
    for (const word& type : dragLaw::dictionaryConstructorTablePtr_->sortedToc())
    {
        const autoPtr<dragLaw> drag(law(type));
        for (const scalar w : {1e-6, 1e-2, 10.0})
        {
            const scalar lone = drag->gamma(1, w, d, rho, mu);
            EXPECT_EQ(drag->gammaInCoveredCell(1, w, d, rho, mu), lone) << type;

            // More than a tenfold with each decade of eps, but for Carman's 1/eps
            scalar last = lone;
            for (const scalar eps : {1e-2, 1e-4, 1e-6, 1e-8})
            {
                const scalar gamma = drag->gammaInCoveredCell(eps, w, d, rho, mu);
                EXPECT_GE(gamma, drag->gamma(eps, w, d, rho, mu)) << type;
                EXPECT_GT(gamma, 9*last) << type << " at " << eps;
                last = gamma;
            }
            EXPECT_GT(last, 1e6*lone) << type << " at " << w;
        }
    }
}


TEST(DragLaw, KeepsItsOwnLimitInACoveredCell)
{
    for (const char* type : {"Beetstra", "DallavalleDiFelice", "ErgunWenYu", "KochHill", "Rong"})
    {
        const autoPtr<dragLaw> drag(law(type));
        EXPECT_EQ
        (
            drag->gammaInCoveredCell(0.1, 0.3, d, rho, mu), drag->gamma(0.1, 0.3, d, rho, mu)
        ) << type;
    }
}


TEST(SelfInducedVelocity, IsThatOfAUniformForceInASphereWhereCellsAreSmall)
{
    // 6/5 of Stokes' speed; l is the cube root of the volume then
    EXPECT_NEAR(selfInduced::inCells(std::cbrt(6/M_PI)), 1.2, 0.01);
}


TEST(SelfInducedVelocity, VanishesInLargeCellsAndWideFilters)
{
    // A point force: 1.178 d/h, and at most sqrt(6) d/L
    EXPECT_NEAR(selfInduced::inCells(1e-6), 1.178e-6, 1e-11);
    scalar last = 1;
    for (const scalar width : {1, 2, 4, 8, 16})
    {
        const scalar Lambda = selfInduced::inFilteredFlow(0.9, width);
        EXPECT_LT(Lambda, min(last, min(scalar(0.9), std::sqrt(6.0)/width)));
        last = Lambda;
    }
    // A filter that sees no difference leaves all of it
    EXPECT_NEAR(selfInduced::inFilteredFlow(0.01, 1), 0.01, 1e-6);
    EXPECT_EQ(selfInduced::inFilteredFlow(0, 4), 0);
}


TEST(SelfInducedVelocity, OfALoneGrainInCreepingFlowIsLambda)
{
    for (const scalar Lambda : {0.1, 0.4})
    {
        EXPECT_NEAR(seen("Stokes", Lambda, 1e-9), 1 - Lambda, 1e-8) << Lambda;
    }
    // And never all of the slip
    EXPECT_NEAR(seen("Stokes", 1.2, 1e-9), 0.25, 1e-12);
}


TEST(SelfInducedVelocity, IsCarriedAwayByInertia)
{
    scalar last = seen("SchillerNaumann", 0.4, 1e-6);
    for (const scalar Re : {0.1, 1.0, 10.0, 100.0, 1000.0})
    {
        const scalar next = seen("SchillerNaumann", 0.4, Re);
        EXPECT_GT(next, last) << Re;
        last = next;
    }
    EXPECT_GT(last, 0.99);
}


TEST(SelfInducedVelocity, OfFastFlowGoesThroughTheSectionOfTheCells)
{
    const selfInduced::inertia cube{0.3, 1}, column{0.3, 0.5};
    // In creeping flow the shape of the cells does not count; what is carried
    // through half of the area is twice as fast, with c r alone
    EXPECT_NEAR(column.factor(1e-6, 0.1)/cube.factor(1e-6, 0.1), 1, 1e-9);
    scalar last = 1;
    for (const scalar Re : {0.1, 1.0, 10.0})
    {
        const scalar ratio = column.factor(Re, 0.05)/cube.factor(Re, 0.05);
        EXPECT_GT(ratio, last) << Re;
        last = ratio;
    }
    EXPECT_GT(last, 1.8);
}


TEST(SelfInducedVelocity, IsNotThereInAUniformBed)
{
    const autoPtr<dragLaw> drag(law("DallavalleDiFelice"));
    for (const scalar eps : {0.9999, 0.6, 0.4})
    {
        const selfInduced::neighbours bed(selfInduced::neighboursOf(eps, eps, 0.1, 0.5));
        EXPECT_EQ(bed.lone, 0);
        EXPECT_EQ(bed.eps, eps);
        EXPECT_EQ
        (
            selfInduced::slipFactor({*drag, d, rho, mu}, volume, bed, 0.4, {0.3, 1}, 0.1), 1
        );
    }
}


TEST(SelfInducedVelocity, OfALoneGrainIsNotScreened)
{
    // A grain of a tenth of its cell; the filter leaves what neighboursOf takes it to leave
    const scalar own = 0.1, x = 0.5, left = 0.32/(1 + 0.2*sqr(x));
    const selfInduced::neighbours lone
    (
        selfInduced::neighboursOf(1 - own, 1 - left*own, own, x)
    );
    EXPECT_EQ(lone.lone, 1);
    EXPECT_EQ(lone.others, 0);
    EXPECT_EQ(lone.eps, 1);
}


TEST(SelfInducedVelocity, KnowsThatHardSpheresKeepAway)
{
    EXPECT_EQ(selfInduced::structureFactor(0), 1);
    // 1 - 8 f to first order, of the second virial coefficient
    EXPECT_NEAR(selfInduced::structureFactor(1e-4), 1 - 8e-4, 1e-6);
    EXPECT_NEAR(selfInduced::structureFactor(0.5), 0.0625/3.5625, 1e-12);
}
