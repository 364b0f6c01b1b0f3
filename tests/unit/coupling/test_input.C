/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "csvTable.H"
#include "dictionaryInput.H"
#include "fluidInput.H"
#include "IFstream.H"
#include "userNames.H"

using namespace Foam;

namespace
{

class CsvTable
:
    public ::testing::Test
{
protected:

    foamTest::emptyCase case_;
    dictionary dict_{foamTest::dict("file a.csv;")};

    csvTable read(const std::string& text)
    {
        case_.writeFile("a.csv", text);
        return csvTable(dict_, case_.path()/"a.csv", {"x", "r"}, {"name", "v"});
    }
};

}


TEST_F(CsvTable, ReadsColumnsInAnyOrder)
{
    const csvTable table(read("r,name,x\n1e-3,glass,-2\n4,\"steel\",5\n"));
    ASSERT_EQ(table.size(), 2);
    EXPECT_EQ(table.number("x", 0), -2);
    EXPECT_EQ(table.number("r", 0), 1e-3);
    EXPECT_EQ(table.text("name", 1), "steel");
    EXPECT_TRUE(table.found("name"));
    EXPECT_FALSE(table.found("v"));
    EXPECT_EQ(table.number("v", 1), 0);
}


TEST_F(CsvTable, PassesOverCommentsBlanksAndCarriageReturns)
{
    const csvTable table(read("# made by hand\r\nx , r\r\n\r\n 1 , 2 \r\n# end\n"));
    ASSERT_EQ(table.size(), 1);
    EXPECT_EQ(table.number("r", 0), 2);
}


TEST_F(CsvTable, MayHaveAHeaderOnly)
{
    EXPECT_EQ(read("x,r\n").size(), 0);
}


TEST_F(CsvTable, NamesFileLineAndColumnOfABadNumber)
{
    for (const std::string bad : {"nan", "inf", "-inf", "1e999", "", "1.2.3", "0x", "1 2", "one"})
    {
        const csvTable table(read("x,r\n1,2\n\n3," + bad + "\n"));
        EXPECT_FOAM_ERROR(table.number("r", 1), "line 4");
        EXPECT_FOAM_ERROR(table.number("r", 1), "a.csv");
        EXPECT_FOAM_ERROR(table.number("r", 1), "column 'r' has the value '" + bad + "'");
        EXPECT_FOAM_ERROR(table.number("r", 1), "allowed: a finite number");
    }
}


TEST_F(CsvTable, RefusesBadHeaders)
{
    EXPECT_FOAM_ERROR(read(""), "a readable file with a header line");
    EXPECT_FOAM_ERROR(read("# x,r\n"), "a readable file with a header line");
    EXPECT_FOAM_ERROR(read("x,radius\n"), "unknown column 'radius'");
    EXPECT_FOAM_ERROR(read("x,x,r\n"), "column 'x' stands twice");
    EXPECT_FOAM_ERROR(read("x,v\n"), "column 'r' is missing");
    EXPECT_FOAM_ERROR(read("x,r\n1\n"), "line 2");
    EXPECT_FOAM_ERROR(read("x,r\n1,2,3\n"), "3 columns");
    EXPECT_FOAM_ERROR
    (
        csvTable(dict_, case_.path()/"none.csv", {"x"}, {}), "none.csv"
    );
}


TEST(DictionaryInput, ReadsNumbersWithAndWithoutDimensions)
{
    const dictionary dict
    (
        foamTest::dict("a 3; b [1 -3 0 0 0 0 0] 4; c c [1 -3 0 0 0 0 0] 5; n 7;")
    );
    EXPECT_EQ(dictionaryInput::getPositive(dict, "a", dimDensity), 3);
    EXPECT_EQ(dictionaryInput::getPositive(dict, "b", dimDensity), 4);
    EXPECT_EQ(dictionaryInput::getScalar(dict, "c", dimDensity, 0, 5), 5);
    EXPECT_EQ(dictionaryInput::getPositiveOrDefault(dict, "x", dimless, 2), 2);
    EXPECT_EQ(dictionaryInput::getScalarOrDefault(dict, "x", dimless, 2, 0), 2);
    EXPECT_EQ(dictionaryInput::getLabelOrDefault(dict, "n", 1, 0), 7);
}


TEST(DictionaryInput, RefusesValuesOutOfRange)
{
    const dictionary dict(foamTest::dict("zero 0; minus -1; big 3; nan nan; word heavy;"));
    using namespace dictionaryInput;

    EXPECT_FOAM_ERROR(getPositive(dict, "zero", dimless), "'zero' has the value 0");
    EXPECT_FOAM_ERROR(getPositive(dict, "zero", dimless), "allowed: a value > 0");
    EXPECT_FOAM_ERROR(getScalar(dict, "minus", dimless, 0), "allowed: a value >= 0");
    EXPECT_FOAM_ERROR(getScalar(dict, "big", dimless, 0, 1), "a value from 0 to 1");
    EXPECT_FOAM_ERROR(getLabelOrDefault(dict, "big", 1, 5), "a value >= 5");
    EXPECT_FOAM_ERROR(getLabelOrDefault(dict, "big", 1, 0, 2), "a value from 0 to 2");
    EXPECT_FOAM_ERROR(getPositive(dict, "nan", dimless), "'nan'");
    EXPECT_FOAM_ERROR(getPositive(dict, "word", dimless), "heavy");
    EXPECT_FOAM_ERROR(getPositive(dict, "none", dimless), "none");
}


TEST(DictionaryInput, RefusesWrongDimensions)
{
    const dictionary dict(foamTest::dict("rho [1 -2 0 0 0 0 0] 1000;"));
    EXPECT_FOAM_ERROR(dictionaryInput::getPositive(dict, "rho", dimDensity), "'rho'");
    EXPECT_FOAM_ERROR
    (
        dictionaryInput::getPositive(dict, "rho", dimDensity), "dimensions [1 -3 0 0 0 0 0]"
    );
}


TEST(DictionaryInput, RefusesUnknownKeywordsAndMissingDictionaries)
{
    const dictionary dict(foamTest::dict("a 1; sub { b 2; }"));
    EXPECT_NO_THROW(dictionaryInput::checkKeywords(dict, {"sub", "a", "c"}));
    EXPECT_FOAM_ERROR(dictionaryInput::checkKeywords(dict, {"a", "c"}), "Unknown keyword 'sub'");
    EXPECT_FOAM_ERROR(dictionaryInput::checkKeywords(dict, {"a", "c"}), "(a c)");
    EXPECT_EQ(dictionaryInput::subDict(dict, "sub").get<label>("b"), 2);
    EXPECT_FOAM_ERROR(dictionaryInput::subDict(dict, "a"), "'a'");
    EXPECT_FOAM_ERROR(dictionaryInput::subDict(dict, "walls"), "'walls' is missing");
}


TEST(DictionaryInput, ReadsWordsThatAreAllowed)
{
    const dictionary dict(foamTest::dict("a one; b \"two\"; n 3; list (one two); sub { c 1; }"));
    using namespace dictionaryInput;
    const wordList allowed({"one", "two"});

    EXPECT_EQ(getWord(dict, "a", allowed), "one");
    EXPECT_EQ(getWord(dict, "b", allowed), "two");
    EXPECT_EQ(getWordOrDefault(dict, "c", "two", allowed), "two");
    EXPECT_FOAM_ERROR(getWord(dict, "c", allowed), "'c' is missing");
    EXPECT_FOAM_ERROR(getWord(dict, "c", allowed), "allowed: (one two)");
    EXPECT_FOAM_ERROR(getWord(dict, "n", allowed), "'n' has the value 3");
    EXPECT_FOAM_ERROR(getWord(dict, "list", allowed), "'list' has the value ( one two )");
    EXPECT_FOAM_ERROR(getWord(dict, "sub", allowed), "'sub' has the value { ... }");
    EXPECT_FOAM_ERROR(getWordOrDefault(dict, "n", "one", allowed), "allowed: (one two)");
}


TEST(FluidInput, RefusesWhatTheSolverWouldPassOver)
{
    const dictionary good(foamTest::dict("FoamFile {} rho 1; nu 1; HeleShaw { gap 1; }"));
    EXPECT_NO_THROW(checkTransportProperties(good));
    const dictionary bad(foamTest::dict("rho 1; nu 1; HeleShow { gap 1; }"));
    EXPECT_FOAM_ERROR(checkTransportProperties(bad), "Unknown keyword 'HeleShow'");
    EXPECT_FOAM_ERROR(checkTransportProperties(bad), "HeleShaw");
    EXPECT_FOAM_ERROR(checkTransportProperties(foamTest::dict("rho 1;")), "'nu'");

    const std::string model("rho 1; transportModel powerLaw; powerLawCoeffs { k 1; }");
    EXPECT_NO_THROW(checkTransportProperties(foamTest::dict(model)));
    EXPECT_FOAM_ERROR(checkTransportProperties(foamTest::dict(model + " nu 1;")), "'nu'");
}


TEST(FluidInput, RefusesAFluidThatStandsStill)
{
    const auto check = [](const std::string& text, const wordList& others = wordList())
    {
        checkPISO(foamTest::dict("solvers { p { relTol 0.1; } } " + text), others);
    };
    EXPECT_NO_THROW(check("PISO { nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; }"));
    EXPECT_NO_THROW(check("PISO {}"));
    EXPECT_NO_THROW(check("PISO { nOuterCorrectors 3; }", {"nOuterCorrectors"}));
    EXPECT_FOAM_ERROR(check("PISO { nCorrectors 0; }"), "'nCorrectors' has the value 0");
    EXPECT_FOAM_ERROR(check("PISO { nCorrectors 0; }"), "a value >= 1");
    EXPECT_FOAM_ERROR(check("PISO { nNonOrthogonalCorrectors -1; }"), "a value >= 0");
    EXPECT_FOAM_ERROR(check("PISO { nCorrector 2; }"), "Unknown keyword 'nCorrector'");
    EXPECT_FOAM_ERROR(check("PISO { nOuterCorrectors 3; }"), "'nOuterCorrectors'");
    EXPECT_FOAM_ERROR(check("PIS0 { nCorrectors 2; }"), "'PISO' is missing");

    const auto solvers = [](const std::string& text)
    {
        checkPISO(foamTest::dict(text + " PISO {}"));
    };
    EXPECT_FOAM_ERROR(solvers("solvers { p { relTol 1; } }"), "'relTol' has the value 1");
    EXPECT_FOAM_ERROR(solvers("solvers { p { maxIter 0; } }"), "'maxIter' has the value 0");
    EXPECT_FOAM_ERROR(solvers(""), "'solvers' is missing");
}


TEST(FluidInput, RefusesFilesOfOtherSolversByName)
{
    foamTest::emptyCase one;
    EXPECT_NO_THROW(refuseFiles(one.time(), {"MRFProperties"}));
    one.writeFile("constant/MRFProperties", "zone {}");
    EXPECT_FOAM_ERROR(refuseFiles(one.time(), {"MRFProperties"}), "constant/MRFProperties");
    EXPECT_NO_THROW(refuseFiles(one.time(), {"dynamicMeshDict"}));
}


TEST(UserNames, EditsAreCounted)
{
    using dictionaryInput::editDistance;
    EXPECT_EQ(editDistance("tolerance", "tolerance"), 0);
    EXPECT_EQ(editDistance("tolerance", "tolerence"), 1);
    EXPECT_EQ(editDistance("HeleShaw", "HelShow"), 2);
    EXPECT_EQ(editDistance("", "nu"), 2);
    EXPECT_EQ(editDistance("nu", ""), 2);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}


TEST(UserNames, ValuesMayHaveNames)
{
    foamTest::emptyCase one;
    const auto check = [&](const std::string& text)
    {
        one.writeFile("constant/d", text);
        const dictionary dict((IFstream(one.path()/"constant/d"))());
        dictionaryInput::checkKeywords(dict, {"tolerance", "sub", "a"});
        if (dict.found("sub"))
        {
            dictionaryInput::checkKeywords(dict.subDict("sub"), {"tolerance"});
        }
    };
    EXPECT_NO_THROW(check("mytol 1e-6; tolerance $mytol;"));
    EXPECT_NO_THROW(check("mytol 1e-6; tolerance ${mytol};"));
    EXPECT_NO_THROW(check("mytol 1e-6; sub { tolerance $:mytol; }"));
    EXPECT_NO_THROW(check("sub { mytol 1e-6; tolerance $mytol; }"));
    EXPECT_NO_THROW(check("mytol 1e-6; sub { tolerance $..mytol; }"));
    EXPECT_NO_THROW(check("base { x 1e-6; } sub { tolerance $:base.x; }"));
    EXPECT_NO_THROW(check("base { tolerance 1e-6; } sub { $base; }"));

    EXPECT_FOAM_ERROR(check("mytol 1e-6; tolerance 1e-6;"), "Unknown keyword 'mytol'");
    EXPECT_FOAM_ERROR(check("mytol 1; tolerance 1; // $mytol\n"), "'mytol'");
    EXPECT_FOAM_ERROR(check("mytol 1; tolerance 1; /* $mytol */"), "'mytol'");
    EXPECT_FOAM_ERROR(check("mytol 1; mytol2 2; tolerance $mytol2;"), "'mytol'");
    EXPECT_FOAM_ERROR(check("tolerence 1;"), "$ uses");
}


TEST(UserNames, FilesOfParametersMayBeShared)
{
    foamTest::emptyCase one;
    const auto check = [&](const std::string& parameters)
    {
        one.writeFile("constant/parameters", parameters);
        one.writeFile("constant/d", "#include \"parameters\"\ntolerance $mytol;");
        const dictionary dict((IFstream(one.path()/"constant/d"))());
        dictionaryInput::checkKeywords(dict, {"tolerance", "maxSweeps"});
    };
    EXPECT_NO_THROW(check("mytol 1e-6;"));
    EXPECT_NO_THROW(check("mytol 1e-6; inletVelocity 1; U 2;"));
    EXPECT_NO_THROW(check("half 5e-7; mytol $half;"));
    EXPECT_FOAM_ERROR(check("mytol 1e-6; maxSweep 200;"), "Unknown keyword 'maxSweep'");
}
