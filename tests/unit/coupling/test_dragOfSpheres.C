/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "dragLaw.H"

using namespace Foam;

namespace
{

const scalar d = 0.002, rho = 1200, mu = 0.05;

// gamma d^2/mu at a superficial Reynolds number
scalar coefficient(const std::string& law, const scalar eps, const scalar Re)
{
    const autoPtr<dragLaw> drag(dragLaw::New(foamTest::dict("type " + law + "; "), 3));
    return drag->gamma(eps, Re*mu/(eps*rho*d), d, rho, mu)*sqr(d)/mu;
}

scalar ergun(const scalar eps, const scalar Re)
{
    return (150*(1 - eps) + 1.75*Re)/eps;
}

}


TEST(DragOfSpheres, IsThatOfStokesForALoneSphereInCreepingFlow)
{
    for (const char* law : {"Beetstra", "KochHill", "SchillerNaumann", "Stokes", "ErgunWenYu"})
    {
        EXPECT_NEAR(coefficient(law, 1, 0), 18, 1e-12) << law;
    }
    for (const char* law : {"DiFelice", "Rong"})
    {
        EXPECT_NEAR(coefficient(law, 1, 0), 17.28, 1e-12) << law;    // Dallavalle's 4.8^2 3/4
    }
    EXPECT_NEAR(coefficient("thesisPrinted", 1, 0), sqr(5.88), 1e-12);
}


TEST(DragOfSpheres, GrowsFromStokesToNewton)
{
    // drag coefficients 24/Re (1 + 0.15 Re^0.687) and 0.44; they meet within half a per cent
    EXPECT_NEAR(coefficient("SchillerNaumann", 1, 100), 0.75*100*1.09173, 1e-3);
    EXPECT_NEAR(coefficient("SchillerNaumann", 1, 1e5), 0.75*0.44*1e5, 1e-7);
    EXPECT_NEAR
    (
        coefficient("SchillerNaumann", 1, 1001)/coefficient("SchillerNaumann", 1, 999), 1, 0.01
    );
    EXPECT_EQ(coefficient("Stokes", 0.5, 1000), coefficient("Stokes", 1, 0));
}


TEST(DragOfSpheres, IsErgunsInABedAndWenAndYusAbove)
{
    for (const scalar Re : {0.1, 10.0, 500.0, 2000.0})
    {
        EXPECT_NEAR(coefficient("ErgunWenYu", 0.4, Re)/ergun(0.4, Re), 1, 1e-12);
        EXPECT_NEAR
        (
            coefficient("ErgunWenYu", 0.9, Re)/coefficient("SchillerNaumann", 1, Re),
            std::pow(0.9, -2.65), 1e-12
        );
    }
}


TEST(DragOfSpheres, HasTheFormOfCarmanInDenseBeds)
{
    // 180 phi^2/eps^3 of the pressure drop, that is 180 phi/eps here; Beetstra adds the term of
    // dilute beds
    EXPECT_NEAR(coefficient("KochHill", 0.4, 0)/(180*0.6/0.4), 1, 1e-12);
    EXPECT_NEAR(coefficient("Beetstra", 0.4, 0)/(180*0.6/0.4), 1, 0.06);

    // Koch and Hill's two branches, which meet at a fraction of 0.4 within two per cent
    EXPECT_NEAR(coefficient("KochHill", 0.6001, 0)/coefficient("KochHill", 0.5999, 0), 1, 0.02);
}


TEST(DragOfSpheres, HasErgunsPressureDropInAPackedBed)
{
    // fits to computed and measured beds differ by a fifth
    for (const char* law : {"Beetstra", "DiFelice", "KochHill", "Rong"})
    {
        for (const scalar Re : {1.0, 10.0, 100.0})
        {
            EXPECT_NEAR(coefficient(law, 0.4, Re)/ergun(0.4, Re), 1, 0.2) << law << " at " << Re;
        }
    }
}


TEST(DragOfSpheres, OfDiFeliceSettlesAsRichardsonAndZakiFound)
{
    // Without a flux of the mixture gamma v/eps = eps (rho_p - rho) g, v the speed of settling,
    // in creeping flow as eps^2/gamma; Richardson and Zaki's power is 4.65
    for (const scalar eps : {0.9, 0.8, 0.7, 0.6})
    {
        const scalar speed =
            sqr(eps)*coefficient("DiFelice", 1, 0)/coefficient("DiFelice", eps, 0);
        EXPECT_NEAR(speed/std::pow(eps, 4.65), 1, 0.03) << eps;
    }
}


TEST(DragOfSpheres, OfThePrintedLawIsTwiceThatOfDallavalle)
{
    // (5.88/4.8)^2/(3/4), away from the dip that the print leaves out
    const autoPtr<dragLaw> sphere
    (
        dragLaw::New(foamTest::dict("type DallavalleDiFelice; shape sphere;"), 3)
    );
    EXPECT_NEAR
    (
        coefficient("thesisPrinted", 0.5, 0)*mu/sqr(d)/sphere->gamma(0.5, 0, d, rho, mu),
        sqr(5.88/4.8)/0.75, 1e-12
    );
}


TEST(DragOfSpheres, RefusesWhatItDoesNotKnow)
{
    EXPECT_FOAM_ERROR
    (
        dragLaw::New(foamTest::dict("type Beetstra; form sphere;"), 3), "form"
    );
}
