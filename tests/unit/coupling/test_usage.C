/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "adjustableTimeStep.H"
#include "dragLaw.H"
#include "effectiveConductivity.H"
#include "effectiveViscosity.H"
#include "functionOfTemperature.H"
#include "grainHeat.H"
#include "grainMaterials.H"
#include "heatLaw.H"
#include "HeleShaw.H"
#include "liftLaw.H"
#include "lubricationLaw.H"
#include "planarCells.H"
#include "plateHeat.H"
#include "sizeDistribution.H"
#include "voidFractionMethod.H"

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

// Examples of the headers below src: the \verbatim block that follows a line "Usage"
std::map<std::string, std::string> examples()
{
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GRAINFOAM_SRC))
    {
        const std::filesystem::path& path = entry.path();
        if (path.extension() != ".H" || path.parent_path().filename() == "lnInclude")
        {
            continue;
        }
        std::stringstream text;
        text << std::ifstream(path).rdbuf();
        const std::string header = text.str();

        const auto usage = header.find("\nUsage\n");
        const auto begin = header.find("\\verbatim\n", usage);
        const auto end = header.find("\\endverbatim", begin);
        if (usage != std::string::npos && end != std::string::npos)
        {
            found[path.stem()] = header.substr(begin + 10, end - begin - 10);
        }
    }
    return found;
}

std::vector<std::string> namesOfExamples()
{
    std::vector<std::string> names;
    for (const auto& example : examples())
    {
        names.push_back(example.first);
    }
    return names;
}

dictionary example(const std::string& header)
{
    return foamTest::dict(examples().at(header));
}

class Usage
:
    public ::testing::TestWithParam<std::string>
{};

INSTANTIATE_TEST_SUITE_P
(
    Of, Usage, ::testing::ValuesIn(namesOfExamples()),
    [](const auto& info) { return info.param; }
);

}


TEST_P(Usage, IsADictionary)
{
    // Sub-dictionaries only, and no entry that lost its semicolon
    const dictionary dict(example(GetParam()));
    EXPECT_FALSE(dict.empty());
    for (const word& keyword : dict.toc())
    {
        ASSERT_TRUE(dict.isDict(keyword)) << keyword;
        for (const word& entry : dict.subDict(keyword).sortedToc())
        {
            const dictionary& sub = dict.subDict(keyword);
            EXPECT_TRUE(sub.isDict(entry) || sub.lookup(entry).size()) << entry;
        }
    }
}


TEST(UsageOfHeaders, IsThereForWhatIsSelectable)
{
    const auto found = examples();
    for (const char* name : {"Coulomb", "DallavalleDiFelice", "centroid", "csvGrains",
        "exactOverlap", "gaussianKernel", "grainHeat", "grainMaterials", "grainTracks",
        "grainWalls", "satellitePoints"})
    {
        EXPECT_TRUE(found.count(name)) << name;
    }
}


TEST(UsageOfHeaders, IsAcceptedByTheClasses)
{
    for (const char* name :
        {
            "Beetstra", "DallavalleDiFelice", "DiFelice", "ErgunWenYu", "KochHill", "Rong",
            "SchillerNaumann", "Stokes", "thesisPrinted"
        })
    {
        const label nDimensions = std::string(name) == "DallavalleDiFelice" ? 2 : 3;
        EXPECT_NO_THROW(dragLaw::New(example(name).subDict("drag"), nDimensions));
    }

    for (const char* name : {"Magnus", "SaffmanMei"})
    {
        EXPECT_EQ(liftLaw::all(example(name)).size(), 1);
    }
    for (const char* name : {"Davis", "Legendre"})
    {
        EXPECT_TRUE(lubricationLaw::New(example(name)).valid());
    }
    for (const char* name : {"Batchelor", "Einstein", "KriegerDougherty", "noEffectiveViscosity"})
    {
        EXPECT_NO_THROW(effectiveViscosity::New(example(name)));
    }
    for (const char* name : {"Maxwell", "ZehnerSchluender", "noEffectiveConductivity"})
    {
        EXPECT_NO_THROW(effectiveConductivity::New(example(name), 3));
    }
    EXPECT_GT(HeleShawPlates(example("HeleShaw")), 0);

    for (const char* name :
        {"ChurchillBernstein", "Gunn", "Henry", "LiMason", "RanzMarshall", "WakaoKaguei"})
    {
        const label nDimensions = std::string(name) == "ChurchillBernstein" ? 2 : 3;
        EXPECT_NO_THROW(heatLaw::New(example(name).subDict("heatTransfer"), nDimensions));
    }
    const plateHeat plateHeat(example("plateHeat"));
    EXPECT_NEAR(plateHeat.coefficient(), 2*350/15e-3, 1e-6);
    const dictionary function(example("functionOfTemperature"));
    const dictionary& properties = function.subDict("transportProperties");
    EXPECT_NO_THROW(functionOfTemperature(properties, "kappa", dimless));
    EXPECT_NO_THROW(functionOfTemperature(properties, "mu", dimless));

    const adjustableTimeStep::limits limits(example("adjustableTimeStep").subDict("controlDict"));
    EXPECT_TRUE(limits.adjusts);
    EXPECT_EQ(limits.maxDeltaT, 1e-2);

    foamTest::planarCase planar(2, 2);
    const planarMesh plane(planar.mesh());
    const planarCells cells(plane);
    for (const char* name :
        {"centroid", "diffused", "exactOverlap", "gaussianKernel", "satellitePoints"})
    {
        EXPECT_NO_THROW(voidFractionMethod::New(example(name).subDict("voidFraction"), cells));
    }

    for (const char* name :
        {"constantSize", "lognormalSize", "normalSize", "sieveSize", "uniformSize"})
    {
        const autoPtr<sizeDistribution> sizes =
            sizeDistribution::New(example(name).subDict("distribution"));
        for (const label dimensions : {2, 3})
        {
            EXPECT_GT(sizes->sizes(dimensions)(0.5), 0.5e-3) << name;
            EXPECT_LT(sizes->sizes(dimensions)(0.5), 1.5e-3) << name;
        }
    }

    dictionary thermal(example("grainHeat"));
    thermal.add("contactLaws", dictionary());
    const grainSpace<2> space(planar.mesh());
    const grainMaterials thermalMaterials(thermal);
    const grainWalls<2> walls(thermal.subDict("walls"), space, thermalMaterials);
    const auto heat = grainHeat<2>::New(thermal, space, thermalMaterials, walls);
    ASSERT_TRUE(heat);
    EXPECT_EQ(heat->walls(), wordList({"hotPlate"}));

    const dictionary dict(example("grainMaterials"));
    const grainMaterials materials(dict);
    EXPECT_EQ(materials.names(), wordList({"glass", "steel"}));
    EXPECT_EQ(materials.density(1), 7800);
    EXPECT_EQ(materials.contactTable()(0, 1).friction, 0.2);
}
