// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Contact problems in FCLIB files.

#include "nscd/io/Hdf5.hpp"
#include "nscd/problem/Fclib.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

namespace
{

using nscd::FclibProblem;
using nscd::FclibStorage;
using nscd::Hdf5File;
using nscd::Vector;

/// A file that is gone after the test.
class Fclib : public testing::Test
{
protected:
    Fclib() : file(testing::TempDir() + "fclib" + std::to_string(::getpid()) + ".hdf5") {}
    ~Fclib() override { std::remove(file.c_str()); }

    /// What readFclib() says, less the name of the file that must begin it.
    std::string error() const
    {
        try
        {
            nscd::readFclib(file);
        }
        catch (const std::runtime_error& e)
        {
            const std::string message = e.what();
            EXPECT_EQ(message.rfind(file + ": ", 0), 0u) << message;
            return message.substr(file.size() + 2);
        }
        return "no error";
    }

    template <class T>
    void replace(const std::string& set, const std::vector<T>& values) const
    {
        Hdf5File out(file, Hdf5File::Mode::modify);
        if (out.contains(set))
        {
            out.remove(set);
        }
        out.write(set, nscd::Table<T>{values.size(), 1, values}, "1");
        out.close();
    }

    void integers(const std::string& set, const std::vector<std::int32_t>& values) const { replace(set, values); }
    void numbers(const std::string& set, const std::vector<double>& values) const { replace(set, values); }

    void remove(const std::string& set) const
    {
        Hdf5File out(file, Hdf5File::Mode::modify);
        out.remove(set);
        out.close();
    }

    const std::string file;
};

/// Two contacts, W without symmetry and with holes.
template <int D>
FclibProblem<D> example()
{
    std::vector<typename nscd::SparseProblem<D>::Entry> entries;
    for (int i = 0; i < 2 * D; ++i)
    {
        entries.push_back({i, i, 10.0 + i});
    }
    entries.push_back({0, D, 0.5});
    entries.push_back({D + 1, 0, -0.25});
    entries.push_back({1, 0, 3});
    nscd::Vectors<D> q(2), r(2);
    for (int i = 0; i < D; ++i)
    {
        q[0][i] = i - 1;
        q[1][i] = 2 * i - 1;
        r[0][i] = 0.1 * i;
        r[1][i] = 7 - i;
    }
    return {{q, {0.3, 0.7}, entries}, {{r, q}, {q, r}}, {}};
}

template <int D>
void expectSame(const FclibProblem<D>& a, const FclibProblem<D>& b)
{
    ASSERT_EQ(a.problem.contacts(), b.problem.contacts());
    EXPECT_EQ(a.problem.q(), b.problem.q());
    EXPECT_EQ(a.problem.friction(), b.problem.friction());
    for (int c = 0; c < a.problem.contacts(); ++c)
    {
        const auto* other = b.problem.begin(c);
        for (const auto* n = a.problem.begin(c); n != a.problem.end(c); ++n, ++other)
        {
            ASSERT_NE(other, b.problem.end(c));
            EXPECT_EQ(n->contact, other->contact);
            EXPECT_EQ(n->W, other->W);
        }
    }
    ASSERT_EQ(a.guesses.size(), b.guesses.size());
    for (std::size_t k = 0; k < a.guesses.size(); ++k)
    {
        EXPECT_EQ(a.guesses[k].r, b.guesses[k].r);
        EXPECT_EQ(a.guesses[k].u, b.guesses[k].u);
    }
    ASSERT_EQ(a.solution.has_value(), b.solution.has_value());
    if (a.solution)
    {
        EXPECT_EQ(a.solution->r, b.solution->r);
        EXPECT_EQ(a.solution->u, b.solution->u);
    }
}

template <class N>
class FclibIn : public Fclib
{
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FclibIn, Dimensions);

TYPED_TEST(FclibIn, ReadsWhatItHasWrittenInEveryStorage)
{
    constexpr int D = TypeParam::value;
    for (const auto storage : {FclibStorage::triplets, FclibStorage::columns, FclibStorage::rows})
    {
        nscd::writeFclib<D>(this->file, example<D>(), storage);
        expectSame(std::get<FclibProblem<D>>(nscd::readFclib(this->file)), example<D>());
    }
}

TYPED_TEST(FclibIn, SolutionIsAddedOrReplacedAndNothingElse)
{
    constexpr int D = TypeParam::value;
    nscd::writeFclib<D>(this->file, example<D>());
    this->numbers("fclib_local/info/more", {1, 2, 3});
    FclibProblem<D> expected = example<D>();
    for (int k = 0; k < 2; ++k)
    {
        expected.solution = expected.guesses[k];
        nscd::writeFclibSolution<D>(this->file, this->file, *expected.solution);
        expectSame(std::get<FclibProblem<D>>(nscd::readFclib(this->file)), expected);
        EXPECT_EQ(Hdf5File(this->file, Hdf5File::Mode::read).read<double>("fclib_local/info/more").values[2], 3);
    }
    EXPECT_FALSE(std::filesystem::exists(this->file + ".part"));
}

TEST_F(Fclib, SolutionGoesToAnotherFileOrThroughALink)
{
    nscd::writeFclib<2>(file, example<2>());
    const std::string other = file + ".other", link = file + ".link";
    nscd::writeFclibSolution<2>(file, other, example<2>().guesses[0]);
    EXPECT_TRUE(std::get<FclibProblem<2>>(nscd::readFclib(other)).solution);
    EXPECT_FALSE(std::get<FclibProblem<2>>(nscd::readFclib(file)).solution);
    std::filesystem::create_symlink(file, link);
    nscd::writeFclibSolution<2>(file, link, example<2>().guesses[0]);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_TRUE(std::get<FclibProblem<2>>(nscd::readFclib(file)).solution);
    std::remove(other.c_str());
    std::remove(link.c_str());
}

TEST_F(Fclib, HasTheFormOfItsDefinition)
{
    // W = [1 2; 0 4] in rows: columns 0 1 1, rows from 0, 2 to 3
    nscd::writeFclib<2>(file, {{{{-1, 2}}, {0.5}, {{0, 0, 1}, {0, 1, 2}, {1, 1, 4}}}, {}, {}});
    const Hdf5File in(file, Hdf5File::Mode::read);
    using Integers = std::vector<std::int32_t>;
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/spacedim").values, Integers{2});
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/W/m").values, Integers{2});
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/W/n").values, Integers{2});
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/W/nz").values, Integers{-2});
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/W/nzmax").values, Integers{3});
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/W/p").values, (Integers{0, 2, 3}));
    EXPECT_EQ(in.read<std::int32_t>("fclib_local/W/i").values, (Integers{0, 1, 1}));
    EXPECT_EQ(in.read<double>("fclib_local/W/x").values, (std::vector<double>{1, 2, 4}));
    EXPECT_EQ(in.read<double>("fclib_local/vectors/q").values, (std::vector<double>{-1, 2}));
    EXPECT_EQ(in.read<double>("fclib_local/vectors/mu").values, std::vector<double>{0.5});
    EXPECT_FALSE(in.contains("guesses"));
    EXPECT_FALSE(in.contains("solution"));
}

TEST_F(Fclib, TripletsMayBeFewerThanThereIsRoomFor)
{
    nscd::writeFclib<2>(file, {{{{-1, 2}}, {0.5}, {{0, 0, 1}, {1, 1, 1}}}, {}, {}});
    integers("fclib_local/W/nz", {3});
    integers("fclib_local/W/nzmax", {5});
    integers("fclib_local/W/i", {1, 0, 1});
    integers("fclib_local/W/p", {0, 0, 1});
    numbers("fclib_local/W/x", {5, 2, 4, 1e30, std::numeric_limits<double>::quiet_NaN()});
    const auto problem = std::get<FclibProblem<2>>(nscd::readFclib(file)).problem;
    // i is the row, p the column
    EXPECT_EQ(problem.own(0), (nscd::Block<2>() << 2, 0, 5, 4).finished());
}

TEST_F(Fclib, FilesThatAreNoneAreRefused)
{
    EXPECT_NE(error().find("cannot be opened"), std::string::npos);
    std::ofstream(file) << "not HDF5";
    EXPECT_NE(error().find("cannot be opened"), std::string::npos);
    Hdf5File(file, Hdf5File::Mode::create).close();
    EXPECT_EQ(error(), "there is no fclib_local");
    integers("fclib_global/spacedim", {3});
    EXPECT_EQ(error(), "there is no fclib_local, and fclib_global is not supported");
}

TEST_F(Fclib, WhatIsMissingIsNamed)
{
    for (const std::string set : {"fclib_local/spacedim", "fclib_local/W/m", "fclib_local/W/n", "fclib_local/W/nz",
                                  "fclib_local/W/p", "fclib_local/W/i", "fclib_local/W/x", "fclib_local/vectors/q",
                                  "fclib_local/vectors/mu", "guesses/2/r", "guesses/number_of_guesses"})
    {
        nscd::writeFclib<3>(file, example<3>());
        remove(set);
        EXPECT_EQ(error(), "there is no " + set);
    }
}

TEST_F(Fclib, WhatIsWrongIsNamed)
{
    const auto wrong = [this](FclibStorage storage, const std::string& set, const auto& values)
    {
        nscd::writeFclib<2>(file, example<2>(), storage);
        replace(set, values);
        return error();
    };
    using Integers = std::vector<std::int32_t>;
    using Numbers = std::vector<double>;
    const double infinity = std::numeric_limits<double>::infinity();
    const auto rows = FclibStorage::rows, triplets = FclibStorage::triplets;
    const std::string w = "fclib_local/W/";

    EXPECT_EQ(wrong(rows, "fclib_local/spacedim", Integers{4}), "fclib_local/spacedim is 4 instead of 2 or 3");
    EXPECT_EQ(wrong(rows, "fclib_local/spacedim", Integers{3}),
              "fclib_local/W/m is 4, not a multiple of the dimension 3");
    EXPECT_EQ(wrong(rows, w + "m", Integers{5}), "fclib_local/W/m and n: W of 5 x 4 is not square");
    EXPECT_EQ(wrong(rows, w + "nz", Integers{-3}),
              "fclib_local/W/nz is -3: -2, -1 or the number of triplets is possible");
    EXPECT_EQ(wrong(rows, w + "p", Integers{0, 2}), "fclib_local/W/p has 2 instead of 5 entries");
    EXPECT_EQ(wrong(rows, w + "p", Integers{0, 3, 2, 5, 7}),
              "fclib_local/W/p: entry 2 is 2, less than the one before or than 0");
    EXPECT_EQ(wrong(rows, w + "p", Integers{0, 2, 4, 5, 99}), "fclib_local/W/i has 7 instead of 99 entries");
    EXPECT_EQ(wrong(rows, w + "i", Integers{0, 2, 0, 1, 4, 0, 3}), "fclib_local/W/i: entry 4 is 4, outside 0 ... 3");
    EXPECT_EQ(wrong(rows, w + "x", Numbers{1, 2, 3, 4, 5, 6}), "fclib_local/W/x has 6 instead of 7 entries");
    EXPECT_EQ(wrong(rows, w + "x", Numbers{1, 2, infinity, 4, 5, 6, 7}), "fclib_local/W/x: entry 2 is not finite");
    EXPECT_EQ(wrong(rows, w + "x", Numbers{-1, 2, 3, 4, 5, 6, 7}), "fclib_local: contact 0: W_NN is not positive");
    EXPECT_EQ(wrong(triplets, w + "p", Integers{0, 1, 2, 3, -1, 2, 0}),
              "fclib_local/W/p: entry 4 is -1, outside 0 ... 3");
    EXPECT_EQ(wrong(triplets, w + "nz", Integers{8}), "fclib_local/W/i has 7 instead of 8 entries");
    EXPECT_EQ(wrong(rows, "fclib_local/vectors/q", Numbers{1, 2}), "fclib_local/vectors/q has 2 instead of 4 entries");
    EXPECT_EQ(wrong(rows, "fclib_local/vectors/q", Numbers{1, 2, 3, std::nan("")}),
              "fclib_local/vectors/q: entry 3 is not finite");
    EXPECT_EQ(wrong(rows, "fclib_local/vectors/mu", Numbers{0.3}), "fclib_local/vectors/mu has 1 instead of 2 entries");
    EXPECT_EQ(wrong(rows, "fclib_local/vectors/mu", Numbers{0.3, -0.5}),
              "fclib_local: contact 1: the coefficient of friction -0.5 is not 0 or more");
    EXPECT_EQ(wrong(rows, "fclib_local/R/m", Integers{3}),
              "fclib_local/V and R: equality constraints are not supported");
    EXPECT_EQ(wrong(rows, "guesses/1/u", Numbers{0}), "guesses/1/u has 1 instead of 4 entries");
    EXPECT_EQ(wrong(rows, "solution/r", Numbers{0}), "solution/r has 1 instead of 4 entries");
}

TEST_F(Fclib, TextInThePlaceOfNumbersIsRefused)
{
    nscd::writeFclib<2>(file, example<2>());
    // A group where a data set should be
    remove("fclib_local/vectors/mu");
    numbers("fclib_local/vectors/mu/inside", {1});
    EXPECT_EQ(error().rfind("cannot read fclib_local/vectors/mu: ", 0), 0u) << error();
}

TEST_F(Fclib, WritingWhereItIsNotPossibleLeavesNothing)
{
    EXPECT_THROW(nscd::writeFclib<2>("/nonexistent/directory/problem.hdf5", example<2>()), std::runtime_error);
    EXPECT_THROW(nscd::writeFclibSolution<2>(file, file, example<2>().guesses[0]), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_FALSE(std::filesystem::exists(file + ".part"));
}

}  // namespace
