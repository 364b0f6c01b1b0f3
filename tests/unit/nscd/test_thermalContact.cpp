// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Conductance of one contact.

#include "nscd/heat/ThermalContact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace nscd::conductance;
using nscd::ConductanceLaw;
using nscd::ThermalContact;
using nscd::ThermalMaterial;

namespace thermalContact
{

constexpr double infinity = std::numeric_limits<double>::infinity();

const ThermalMaterial glass{1.4, 6e10, 0.22}, steel{50, 2.1e11, 0.3};

/// Glass bead of 1 mm on a steel one of 3 mm, 1 mm long, pressed by 1 mN.
const ThermalContact contact{glass, steel, 5e-4, 1.5e-3, 1e-3, 1e-3};

const std::vector<ConductanceLaw> laws{spheres, strip, rowOfSpheres, squarePatch, spot};

ThermalContact withForce(double force)
{
    ThermalContact c(contact);
    c.force = force;
    return c;
}

/// H(2 F)/H(F) as a power of two.
double exponent(const ConductanceLaw& law, double force = 1e-3)
{
    return std::log2(law(withForce(2 * force)) / law(withForce(force)));
}

TEST(HertzContact, ObeysTheOtherRelationsOfTheTheory)
{
    const double e = nscd::effectiveModulus(contact), r = nscd::effectiveRadius(contact);
    EXPECT_DOUBLE_EQ(1 / e, (1 - 0.22 * 0.22) / 6e10 + (1 - 0.09) / 2.1e11);
    EXPECT_DOUBLE_EQ(r, 3.75e-4);

    // Spheres: approach a^2/R*, force 4/3 E* sqrt(R*) approach^(3/2)
    const double a = nscd::hertzRadius(contact);
    EXPECT_NEAR(4.0 / 3 * e * std::sqrt(r) * std::pow(a * a / r, 1.5), 1e-3, 1e-15);

    // Cylinders: largest pressure 2 F/(pi b L) = E* b/(2 R*)
    const double b = nscd::hertzHalfWidth(contact);
    EXPECT_NEAR(2 * 1e-3 / (M_PI * b * 1e-3) / (e * b / (2 * r)), 1, 1e-14);
}

TEST(HertzContact, WithAWallIsThatOfAnInfiniteRadius)
{
    ThermalContact wall(contact);
    wall.secondRadius = infinity;
    EXPECT_EQ(nscd::effectiveRadius(wall), 5e-4);
    ThermalContact huge(wall);
    huge.secondRadius = 1e9;
    for (const ConductanceLaw& law : {ConductanceLaw(spheres), ConductanceLaw(squarePatch), ConductanceLaw(spot)})
    {
        EXPECT_NEAR(law(huge) / law(wall), 1, 1e-12);
    }
}

TEST(Conductance, OfSpheresIsThatOfTwoSpotsInSeries)
{
    // Each half space resists with 1/(4 k a)
    const double a = std::cbrt(3 * 1e-3 * 3.75e-4 / (4 * nscd::effectiveModulus(contact)));
    EXPECT_NEAR(1 / spheres(contact), 1 / (4 * 1.4 * a) + 1 / (4 * 50 * a), 1e-9 / spheres(contact));
}

TEST(Conductance, OfAStripIsThatOfTheFourierSeries)
{
    // A cylinder, the flux of an isothermal strip of half angle beta entering, heated uniformly: the strip is warmer
    // than the mean by (sum_n J0(n beta)^2/n + 1/8) per unit of heat over pi k L.  The rest of the sum is that of
    // J0^2 = 1/(pi n beta), oscillations averaged.
    const double beta = 0.02;
    const int terms = 200000;
    double sum = 1 / (M_PI * beta * terms);
    for (int n = terms; n > 0; --n)
    {
        sum += std::pow(::j0(n * beta), 2) / n;
    }
    ThermalContact pair{glass, steel, 1e-3, 1e-3, 1, 1e-2};
    pair.force = M_PI * 1e-2 * nscd::effectiveModulus(pair) * std::pow(beta * 1e-3, 2) / (4 * 5e-4);
    ASSERT_NEAR(nscd::hertzHalfWidth(pair), beta * 1e-3, 1e-15);
    const double resistance = (sum + 0.125) / (M_PI * 1e-2) * (1 / 1.4 + 1 / 50.0);
    EXPECT_NEAR(strip(pair) * resistance, 1, 1e-4);  // the rim is curved: beta^2
}

TEST(Conductance, OfASquarePatchIsTheThesisFormulaWithItsLength)
{
    // 4 k sqrt(L) (F d*/(2 pi L E*))^(1/4), 1/d* = 1/d_i + 1/d_j; the Patil bead: 1.3e-5 W/K
    const double d = 7.5e-4, k = nscd::meanConductivity(contact);
    EXPECT_NEAR(k, 2 / (1 / 1.4 + 1 / 50.0), 1e-15);
    const double bracket = 1e-3 * d / (2 * M_PI * 1e-3 * nscd::effectiveModulus(contact));
    EXPECT_NEAR(squarePatch(contact), 4 * k * std::sqrt(1e-3) * std::pow(bracket, 0.25), 1e-15);
    EXPECT_NEAR(spot(contact), 4 * k * std::sqrt(bracket), 1e-15);
}

TEST(Conductance, GrowsWithTheForceAsItsTheorySays)
{
    EXPECT_NEAR(exponent(spheres), 1.0 / 3, 1e-12);
    EXPECT_NEAR(exponent(rowOfSpheres), 1.0 / 3, 1e-12);
    EXPECT_NEAR(exponent(squarePatch), 0.25, 1e-12);
    EXPECT_NEAR(exponent(spot), 0.5, 1e-12);
    EXPECT_GT(exponent(strip), 0);
    EXPECT_LT(exponent(strip), 0.1);
}

TEST(Conductance, VanishesWithTheForce)
{
    for (const ConductanceLaw& law : laws)
    {
        EXPECT_EQ(law(withForce(0)), 0);
        EXPECT_EQ(law(withForce(-1)), 0);
        double before = law(withForce(1));
        for (double force = 0.1; force > 1e-12; force /= 10)
        {
            EXPECT_LT(law(withForce(force)), before);
            before = law(withForce(force));
        }
        EXPECT_GT(before, 0);
    }
}

TEST(Conductance, DoesNotDependOnWhichBodyIsFirst)
{
    const ThermalContact exchanged{steel, glass, 1.5e-3, 5e-4, 1e-3, 1e-3};
    for (const ConductanceLaw& law : laws)
    {
        EXPECT_NEAR(law(exchanged) / law(contact), 1, 1e-14);
    }
}

TEST(Conductance, OfStripsAndRowsIsProportionalToTheLength)
{
    // A plane case twice as deep is two cases side by side, if the law lets it
    ThermalContact twice(contact);
    twice.length *= 2;
    twice.force *= 2;
    EXPECT_NEAR(strip(twice) / strip(contact), 2, 1e-12);
    EXPECT_NEAR(rowOfSpheres(twice) / rowOfSpheres(contact), 2, 1e-12);
    EXPECT_NEAR(squarePatch(twice) / squarePatch(contact), std::sqrt(2), 1e-12);
    EXPECT_NEAR(spot(twice) / spot(contact), 1, 1e-12);
}

TEST(Conductance, OfARowOfOneSphereIsThatOfTheSphere)
{
    ThermalContact one(contact);
    one.length = 2e-3;  // the mean of the diameters
    EXPECT_DOUBLE_EQ(rowOfSpheres(one), spheres(one));
    one.secondRadius = infinity;
    one.length = 1e-3;
    EXPECT_DOUBLE_EQ(rowOfSpheres(one), spheres(one));
}

}  // namespace thermalContact
