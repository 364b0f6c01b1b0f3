/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "heatLaw.H"

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

constexpr scalar air = 0.71;

autoPtr<heatLaw> law(const std::string& type, const label nDimensions = 3)
{
    return heatLaw::New(foamTest::dict("type " + type + ";"), nDimensions);
}

// Nu at a superficial Reynolds number
scalar Nu(const std::string& type, const scalar eps, const scalar Re, const scalar Pr = air)
{
    return law(type)->Nu(eps, Re/eps, Pr);
}

scalar disc(const scalar Re, const scalar Pr = air)
{
    return law("ChurchillBernstein", 2)->Nu(1, Re, Pr);
}

// Lines of tests/cases/reference/nusseltPackedBed.csv by columns' names
std::vector<std::map<std::string, scalar>> table()
{
    std::ifstream file(GRAINFOAM_SRC "/../tests/cases/reference/nusseltPackedBed.csv");
    std::vector<std::string> names;
    std::vector<std::map<std::string, scalar>> rows;
    for (std::string line; std::getline(file, line);)
    {
        if (line[0] == '#')
        {
            continue;
        }
        std::istringstream words(line);
        std::vector<std::string> values;
        for (std::string word; std::getline(words, word, ',');)
        {
            values.push_back(word);
        }
        if (names.empty())
        {
            names = values;
            continue;
        }
        rows.emplace_back();
        for (size_t i = 0; i < names.size(); ++i)
        {
            rows.back()[names[i]] = std::stod(values[i]);
        }
    }
    return rows;
}

// 15 to 8500, the range of Wakao's law
std::vector<scalar> packedBed()
{
    std::vector<scalar> all;
    for (int i = 0; i <= 200; ++i)
    {
        all.push_back(15*std::pow(8500.0/15, i/200.0));
    }
    return all;
}

}


TEST(HeatLaw, HasTheTabulatedValuesOfPackedBeds)
{
    // Two fractions, air and water, Re_s from 1 to 1e4; five digits
    const auto rows = table();
    ASSERT_EQ(rows.size(), 96u);
    const std::map<std::string, std::string> columns
    {
        {"WakaoKaguei", "WakaoKaguei"}, {"Gunn", "Gunn"}, {"RanzMarshall", "RanzMarshall"},
        {"Henry", "Henry"}, {"Henry065", "Henry; dip 0.65"}
    };
    for (auto row : rows)
    {
        for (const auto& column : columns)
        {
            EXPECT_NEAR
            (
                Nu(column.second, row["eps"], row["Re_s"], row["Pr"])/row[column.first],
                1, 6e-5
            )   << column.first << " at eps " << row["eps"] << ", Re " << row["Re_s"];
        }
    }
}


TEST(HeatLaw, OfHenryIsThatOfWakaoInPackedBedsOfAir)
{
    for (const scalar Re : packedBed())
    {
        EXPECT_NEAR(Nu("Henry", 0.45, Re)/Nu("WakaoKaguei", 0.45, Re), 1, 0.1) << Re;
    }
}


TEST(HeatLaw, OfHenryExceedsThatOfWakaoAtLowReynoldsNumbers)
{
    const auto ratio = [](const scalar Re)
    {
        return Nu("Henry", 0.45, Re)/Nu("WakaoKaguei", 0.45, Re);
    };
    EXPECT_NEAR(ratio(1), 2.34, 0.01);
    EXPECT_GT(ratio(8), 1.2);
}


TEST(HeatLaw, OfHenryWithTheDipOfTheDragIsLargerInPackedBeds)
{
    scalar least = GREAT, most = 0;
    for (const scalar Re : packedBed())
    {
        const scalar ratio =
            Nu("Henry; dip 0.65", 0.45, Re)/Nu("WakaoKaguei", 0.45, Re);
        least = min(least, ratio);
        most = max(most, ratio);
    }
    EXPECT_NEAR(least, 1.05, 0.01);
    EXPECT_NEAR(most, 1.39, 0.01);
}


TEST(HeatLaw, IsConductionFromALoneSphereAtRest)
{
    for (const char* type : {"Gunn", "LiMason", "RanzMarshall", "WakaoKaguei"})
    {
        EXPECT_NEAR(Nu(type, 1, 0), 2, 1e-12) << type;
    }
    // Colburn's analogy has no limit of its own: Dallavalle's 4.8^2/12
    EXPECT_NEAR(Nu("Henry", 1, 0, 1), sqr(1.39), 1e-12);
    EXPECT_NEAR(Nu("Henry; PrExponent 0", 1, 0, 7), sqr(1.39), 1e-12);
    EXPECT_NEAR(Nu("Henry", 0.5, 0, 1), sqr(1.39)*std::pow(0.5, -1.8), 1e-12);
    EXPECT_NEAR(disc(0), 0.3, 1e-12);
}


TEST(HeatLaw, OfLiAndMasonIsThatOfRanzAndMarshallForALoneSphere)
{
    for (const scalar Re : {0.0, 1.0, 30.0, 200.0})
    {
        EXPECT_NEAR(Nu("LiMason", 1, Re), Nu("RanzMarshall", 1, Re), 1e-12);
    }
    // The convective part falls as the fluid fraction to 3.5, of the slip's Reynolds number
    EXPECT_NEAR
    (
        (law("LiMason")->Nu(0.8, 1000, air) - 2)/(law("LiMason")->Nu(1, 1000, air) - 2),
        std::pow(0.8, 3.5), 1e-12
    );
}


TEST(HeatLaw, OfLiAndMasonJumpsByLessThanOnePerCentInAir)
{
    for (const scalar Re : {200.0, 1500.0})
    {
        EXPECT_NEAR(Nu("LiMason", 1, Re*(1 + 1e-9))/Nu("LiMason", 1, Re), 1, 0.01) << Re;
    }
}


TEST(HeatLaw, OfADiscIsThatOfACylinderInAir)
{
    // Lange, Durst and Breuer (1998), doi:10.1016/S0017-9310(98)00077-5, computed flow
    for (const scalar Re : {1.0, 10.0, 40.0, 100.0, 200.0})
    {
        const scalar computed =
            0.082*std::sqrt(Re) + 0.734*std::pow(Re, 0.05 + 0.226*std::pow(Re, 0.085));
        EXPECT_NEAR(disc(Re)/computed, 1, 0.07) << Re;
    }
    EXPECT_NEAR(disc(100, 0.7), 5.156, 1e-3);
}


TEST(HeatLaw, GrowsWithTheReynoldsNumber)
{
    for (const char* type : {"Gunn", "RanzMarshall", "WakaoKaguei"})
    {
        scalar last = 0;
        for (const scalar Re : packedBed())
        {
            const scalar now = Nu(type, 0.45, Re);
            EXPECT_GT(now, last) << type << " at " << Re;
            last = now;
        }
    }
}


TEST(HeatLaw, IsPerVolumeOfTheShape)
{
    // Surface over volume 6/d of spheres, 4/d of discs
    const scalar k = 0.025, d = 2e-3;
    EXPECT_NEAR(law("RanzMarshall")->perVolume(2, k, d), 6*2*k/sqr(d), 1e-9);
    EXPECT_NEAR
    (
        law("RanzMarshall; shape sphere", 2)->perVolume(2, k, d), 6*2*k/sqr(d), 1e-9
    );
    EXPECT_NEAR(law("ChurchillBernstein", 2)->perVolume(2, k, d), 4*2*k/sqr(d), 1e-9);
}


TEST(HeatLaw, RefusesLawsThatThereAreNot)
{
    EXPECT_FOAM_ERROR(law("Whitaker"), "WakaoKaguei");
    EXPECT_FOAM_ERROR(heatLaw::New(foamTest::dict("shape sphere;"), 3), "'type'");
    EXPECT_FOAM_ERROR(law("Gunn; n 2"), "'n'");
    EXPECT_FOAM_ERROR(law("Henry; dips 1"), "'dips'");
    EXPECT_FOAM_ERROR(law("Henry; dip 2"), "'dip'");
    EXPECT_FOAM_ERROR(law("Henry; dip -1"), "'dip'");
    EXPECT_FOAM_ERROR(law("Henry; PrExponent 1.5"), "'PrExponent'");
}


TEST(HeatLaw, OfSpheresIsRefusedForDiscs)
{
    for (const char* type : {"Gunn", "Henry", "LiMason", "RanzMarshall", "WakaoKaguei"})
    {
        EXPECT_FOAM_ERROR(law(type, 2), "shape sphere;");
        EXPECT_NO_THROW(law(type + std::string("; shape sphere"), 2));
        EXPECT_NO_THROW(law(type, 3));
    }
}


TEST(HeatLaw, OfDiscsIsRefusedForSpheres)
{
    EXPECT_NO_THROW(law("ChurchillBernstein", 2));
    EXPECT_FOAM_ERROR(law("ChurchillBernstein; shape disc", 3), "three-dimensional");
    EXPECT_FOAM_ERROR(law("ChurchillBernstein; shape sphere", 2), "a law of spheres");

    // Nothing is advised that would be refused
    try
    {
        law("ChurchillBernstein", 3);
        FAIL();
    }
    catch (const Foam::error& err)
    {
        EXPECT_EQ(std::string(err.message()).find("shape disc;"), std::string::npos);
        EXPECT_NE(std::string(err.message()).find("a law of spheres"), std::string::npos);
    }
}
