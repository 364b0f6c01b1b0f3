// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Saved states: bitwise continuation, complete files only, reasons of refusal.

#include "Messages.hpp"
#include "Scene.hpp"

#include "nscd/dynamics/State.hpp"
#include "nscd/io/Hdf5.hpp"

#include <csignal>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

std::string path(const std::string& name)
{
    return testing::TempDir() + "nscd_" + std::to_string(::getpid()) + "_" + name + ".h5";
}

template <int D>
void expectContinuationToBeExact(int perSide)
{
    Scene<D> scene = agitated<D>(perSide, 0.4);
    auto uninterrupted = scene.dynamics();
    for (int i = 0; i < 57; ++i)   // somewhere between two rebuilds of the candidate list
    {
        fall<D>(uninterrupted, up<D>(-g), 5e-3);
    }
    const std::string file = path("state");
    uninterrupted.save(file, 0.285);

    Scene<D> other = agitated<D>(2, 0.4);
    other.walls = scene.walls;
    auto continued = other.dynamics();
    EXPECT_EQ(continued.load(file), 0.285);
    std::remove(file.c_str());
    EXPECT_TRUE(sameBits(uninterrupted, continued));
    for (int i = 0; i < 150; ++i)
    {
        fall<D>(uninterrupted, up<D>(-g), 5e-3);
        fall<D>(continued, up<D>(-g), 5e-3);
        ASSERT_TRUE(sameBits(uninterrupted, continued)) << "in step " << i;
    }
}

/// What load() says about a file.
std::string refusal(const std::string& file)
{
    auto dynamics = agitated<2>(2, 0).dynamics();
    try
    {
        dynamics.load(file);
    }
    catch (const std::runtime_error& error)
    {
        std::remove(file.c_str());
        return error.what();
    }
    return "";
}

/// A file of this format with one attribute or data set spoilt by 'change'.
template <class Change>
std::string spoilt(Change&& change)
{
    const std::string file = path("spoilt");
    agitated<2>(2, 0).dynamics().save(file, 0);
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(id);
    H5Fclose(id);
    return file;
}

void overwriteNumber(hid_t file, const char* name, double value)
{
    const hid_t attribute = H5Aopen(file, name, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(attribute);
}

}  // namespace

TEST(Restart, EqualsAnUninterruptedRunBitForBit)
{
    expectContinuationToBeExact<2>(12);
    expectContinuationToBeExact<3>(5);
}

TEST(Restart, LeavesNoContactsOfTheGrainsBefore)
{
    auto many = agitated<2>(8, 0.4).dynamics();
    Scene<2> one;
    one.add({1, 1});
    one.walls = agitated<2>(8, 0.4).walls;
    const std::string file = path("one");
    one.dynamics().save(file, 0);
    for (int i = 0; i < 20; ++i)
    {
        fall<2>(many, up<2>(-g), 5e-3);
    }
    EXPECT_GT(many.contacts().size(), 5u);
    many.load(file);
    std::remove(file.c_str());
    EXPECT_EQ(many.contacts().size(), 0u);
}

TEST(Restart, FileCanBeReadByNamesAndUnits)
{
    const std::string file = path("names");
    Scene<3> scene = agitated<3>(2, 0.3);
    scene.dynamics().save(file, 1.5);
    const nscd::Hdf5File in(file, nscd::Hdf5File::Mode::read);
    EXPECT_EQ(in.readText("format"), "grainFoam grains");
    EXPECT_EQ(in.readNumber("version"), 2);
    EXPECT_EQ(in.readNumber("dimension"), 3);
    EXPECT_EQ(in.readNumber("time"), 1.5);
    for (const std::string name : {"position", "velocity", "spin", "contactImpulse", "contactSpinImpulse"})
    {
        EXPECT_EQ(in.read<double>(name).columns, 3u) << name;
    }
    EXPECT_EQ(in.read<double>("radius").values, scene.grains.radius);
    EXPECT_EQ(in.read<std::int64_t>("id").values, scene.grains.id);
    std::remove(file.c_str());
}

TEST(Restart, FileOfAKilledProgramIsEitherCompleteOrAbsent)
{
    const std::string file = path("killed");
    const auto dynamics = agitated<2>(60, 0).dynamics();
    int complete = 0;
    for (int attempt = 0; attempt < 12 || (complete == 0 && attempt < 100); ++attempt)   // more on a slow machine
    {
        const pid_t child = ::fork();
        if (child == 0)
        {
            for (int i = 0;; ++i)
            {
                dynamics.save(file, i);
            }
        }
        ::usleep(1000 + 2500 * attempt);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        if (std::ifstream(file))
        {
            auto reader = agitated<2>(2, 0).dynamics();
            EXPECT_NO_THROW(reader.load(file));
            EXPECT_EQ(reader.grains().size(), 3600u);
            ++complete;
        }
    }
    EXPECT_GT(complete, 0);
    std::remove(file.c_str());
    std::remove((file + ".part").c_str());
}

TEST(Restart, MissingFileIsNamed)
{
    const std::string message = refusal("/nowhere/grains.h5");
    EXPECT_NE(message.find("/nowhere/grains.h5: cannot be opened: "), std::string::npos) << message;
    EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

TEST(Restart, TruncatedFileIsRefused)
{
    const std::string file = path("truncated");
    agitated<2>(20, 0).dynamics().save(file, 0);
    ASSERT_EQ(::truncate(file.c_str(), 9000), 0);
    const std::string message = refusal(file);
    EXPECT_NE(message.find("truncated file"), std::string::npos) << message;
}

TEST(Restart, FileThatIsNotHdf5IsRefused)
{
    const std::string file = path("text");
    std::ofstream(file) << "x,y\n1,2\n";
    EXPECT_NE(refusal(file).find("cannot be opened"), std::string::npos);
}

TEST(Restart, OtherDimensionVersionOrFormatIsRefused)
{
    const std::string file = path("3d");
    agitated<3>(2, 0).dynamics().save(file, 0);
    EXPECT_NE(refusal(file).find("its dimension is 3 instead of 2"), std::string::npos);

    const std::string newer = spoilt([](hid_t id) { overwriteNumber(id, "version", 7); });
    EXPECT_NE(refusal(newer).find("its version is 7 instead of 2"), std::string::npos);

    const std::string foreign = spoilt([](hid_t id) { H5Adelete(id, "format"); });
    EXPECT_NE(refusal(foreign).find("cannot read attribute format"), std::string::npos);
}

TEST(Restart, IncompleteOrInconsistentFileIsRefused)
{
    const std::string lost = spoilt([](hid_t id) { H5Ldelete(id, "velocity", H5P_DEFAULT); });
    EXPECT_NE(refusal(lost).find("cannot read velocity"), std::string::npos);

    const std::string swapped = spoilt(
        [](hid_t id)
        {
            H5Ldelete(id, "mass", H5P_DEFAULT);
            H5Lcreate_hard(id, "position", id, "mass", H5P_DEFAULT, H5P_DEFAULT);
        });
    EXPECT_NE(refusal(swapped).find("mass is 4 x 2 instead of 4 x 1"), std::string::npos);

    const std::string negative = spoilt(
        [](hid_t id)
        {
            const hid_t set = H5Dopen2(id, "radius", H5P_DEFAULT);
            const std::vector<double> radius{1, 1, -1, 1};
            H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, radius.data());
            H5Dclose(set);
        });
    EXPECT_NE(refusal(negative).find("grain 102: radius -1 m is not positive"), std::string::npos);
}

TEST(Restart, ContactWithAnUnknownWallIsRefused)
{
    Scene<2> scene;
    scene.walls = {{{-9, -9}, {9, -9}, 1}, {{-5, 0}, {5, 0}, 1}};
    scene.add({0, 1});
    auto dynamics = scene.dynamics();
    fall<2>(dynamics, up<2>(-g), 1e-3);
    const std::string file = path("walls");
    dynamics.save(file, 0);
    scene.walls.pop_back();
    auto other = scene.dynamics();
    try
    {
        other.load(file);
        FAIL();
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_STREQ(error.what(), (file + ": a contact with wall 1 of 1").c_str());
    }
    std::remove(file.c_str());
}

TEST(Restart, WallsAreThoseOfTheSameNames)
{
    Scene<2> scene;
    scene.walls = {{{-9, 0}, {9, 0}, 1, 0}, {{-5, -9}, {-5, 9}, 1, 1}};
    scene.add({0, 1});
    const auto dynamicsOf = [&](std::size_t bodies)
    {
        return nscd::ContactDynamics<2>(scene.grains, scene.walls, scene.table, scene.settings, MPI_COMM_SELF,
                                        std::vector<nscd::WallBody<2>>(bodies));
    };
    const std::string file = path("names");
    {
        auto dynamics = dynamicsOf(2);
        dynamics.setWallNames({{"floor", "side"}, {0, 1}, {0, 1}});
        dynamics.setWallMotion(1, {0, 2}, nscd::Spin<2>::Zero());
        fall<2>(dynamics, up<2>(-g), 1e-3);
        dynamics.save(file, 0);
    }
    std::swap(scene.walls[0], scene.walls[1]);
    scene.walls.push_back({{-9, -9}, {9, -9}, 1, -1});
    std::swap(scene.walls[0].body, scene.walls[1].body);
    auto other = dynamicsOf(2);
    other.setWallNames({{"deep", "side", "floor"}, {1, 2, 0}, {1, 2}});
    other.load(file);
    EXPECT_GT(other.wallBodies()[0].position.y(), 0);
    EXPECT_EQ(other.wallBodies()[1].position.y(), 0);
    const std::string again = path("again");
    other.save(again, 0);
    const auto state = nscd::readState<2>(again);
    ASSERT_EQ(state.impulses.size(), 1U);
    EXPECT_EQ(state.impulses[0].b, ~1);
    EXPECT_GT(state.impulses[0].impulse.normal, 0);

    scene.walls[0].body = -1;
    scene.walls[1].body = 0;
    auto held = dynamicsOf(1);
    held.setWallNames({{"deep", "side", "floor"}, {1, 2, 0}, {2}});
    EXPECT_EQ(messageOf<std::runtime_error>([&] { held.load(file); }),
              file + ": the wall side has moved, and now it has no motion; allowed: its motion, or a start before it"
                     " had any");
    std::remove(file.c_str());
    std::remove(again.c_str());
}

TEST(Restart, MaterialsAreThoseOfTheSameNames)
{
    Scene<2> scene;
    scene.add({0, 1});
    scene.add({3, 1});
    scene.grains.material = {0, 1};
    const std::string file = path("materials");
    const auto saved = [&](nscd::ContactTable table)
    {
        scene.table = std::move(table);
        scene.dynamics().save(file, 0);
    };
    const auto loaded = [&](nscd::ContactTable table)
    {
        Scene<2> other;
        other.table = std::move(table);
        auto dynamics = other.dynamics();
        dynamics.load(file);
        return dynamics.grains().material;
    };
    using Names = std::vector<std::string>;
    using nscd::ContactTable;

    saved(ContactTable(Names{"glass", "steel", "unused"}));
    EXPECT_EQ(loaded(ContactTable(Names{"glass", "steel"})), (std::vector<int>{0, 1}));
    EXPECT_EQ(loaded(ContactTable(Names{"gold", "steel", "glass"})), (std::vector<int>{2, 1}));
    EXPECT_EQ(loaded(ContactTable(3)), (std::vector<int>{0, 1}));
    try
    {
        loaded(ContactTable(Names{"gold", "glass"}));
        FAIL();
    }
    catch (const std::runtime_error& error)
    {
        EXPECT_EQ(error.what(), file + ": grain 101 is of the material steel, which is none of gold glass");
    }

    // As states were before they had names
    saved(ContactTable(2));
    EXPECT_EQ(loaded(ContactTable(Names{"gold", "glass"})), (std::vector<int>{0, 1}));
    std::remove(file.c_str());
}

TEST(Restart, UnwritablePlaceIsNamed)
{
    const auto dynamics = agitated<2>(2, 0).dynamics();
    try
    {
        dynamics.save("/nowhere/grains.h5", 0);
        FAIL();
    }
    catch (const std::runtime_error& error)
    {
        const std::string message = error.what();
        EXPECT_NE(message.find("/nowhere/grains.h5.part: cannot be created: "), std::string::npos) << message;
    }
}
