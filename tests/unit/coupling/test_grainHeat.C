/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "grainHeat.H"

using namespace Foam;

namespace
{

const std::string steel("density 8000; conductivity 50; heatCapacity 500; youngsModulus 2e11;");

// A disc of unit radius that rests on the wall 'bottom' of a unit square of unit depth
struct plate
{
    foamTest::planarCase planar{1, 1};
    grainSpace<2> space{planar.mesh()};
    dictionary dict;
    std::unique_ptr<grainMaterials> materials;
    std::unique_ptr<grainWalls<2>> walls;
    std::unique_ptr<grainHeat<2>> heat;
    nscd::Grains<2> grains;

    plate
    (
        const std::string& ofWall,
        const std::string& ofHeat = "",
        const std::string& ofSteel = steel
    )
    :
        dict
        (
            foamTest::dict
            (
                "materials { steel { " + ofSteel + " } } contactLaws {}"
                "walls { plate { type patches; patches (bottom); material steel; " + ofWall + " }"
                "lid { type patches; patches (top); material steel; } }"
                "heat { " + ofHeat + " }"
            )
        )
    {
        grains.resize(1);
        grains.id[0] = 7;
        grains.radius[0] = 1;
        grains.mass[0] = 3;
        grains.temperature[0] = 300;
    }

    void read()
    {
        materials.reset(new grainMaterials(dict));
        walls.reset(new grainWalls<2>(dict.subDict("walls"), space, *materials));
        heat = grainHeat<2>::New(dict, space, *materials, *walls);
        if (heat)
        {
            heat->check(grains);
        }
    }

    // Index of the wall at the given height
    int wallAt(const double y) const
    {
        return walls->walls()[0].a.y() == y ? 0 : 1;
    }

    nscd::ContactForce<2> contact(const double y) const
    {
        return {0, ~wallAt(y), {0.5, y}, {0, -1}, {0, -9}, 0, 9};
    }

    // The same contact for all of a step
    nscd::Touching<2> touching(const double y, const double dt) const
    {
        return {0, ~wallAt(y), {0.5, y}, 9*dt, dt, 0};
    }

    double conductance() const
    {
        const nscd::ThermalMaterial m{50, 2e11, 0.3};
        return nscd::conductance::strip({m, m, 1, HUGE_VAL, 9, 1});
    }
};

void read(const std::string& wall, const std::string& heat, const std::string& ofSteel)
{
    plate(wall, heat, ofSteel).read();
}

}


TEST(GrainHeat, FlowsFromTheWallThatHasATemperature)
{
    plate p("temperature 400;");
    p.read();
    ASSERT_EQ(p.walls->walls().size(), 2u);
    EXPECT_EQ(p.heat->walls(), wordList({"plate"}));
    EXPECT_EQ(p.heat->heat(p.grains, 0), 3*500*300.0);

    const double h = p.conductance();
    EXPECT_NEAR(p.heat->flow(p.contact(0), p.grains)/(-100*h), 1, 1e-12);
    EXPECT_EQ(p.heat->flow(p.contact(1), p.grains), 0);

    // Implicit Euler: C (T - 300)/dt = H (400 - T)
    const double dt = 20, c = 3*500;
    const double temperature = p.heat->advance
    (
        p.grains, {p.touching(0, dt), p.touching(1, dt)}, dt
    )[0];
    EXPECT_NEAR(temperature - 300, 100*h*dt/(c + h*dt), 1e-10);
    EXPECT_NEAR(p.heat->wallHeat()[0]/(c*(temperature - 300)), 1, 1e-12);
}


TEST(GrainHeat, KeepsWallsOfDifferentTemperatureApart)
{
    // Left, bottom: one line if it were not for the corner; two entries on one line
    foamTest::planarCase planar(2, 1);
    const grainSpace<2> space(planar.mesh());
    const auto walls = [&](const std::string& left, const std::string& right)
    {
        const dictionary dict
        (
            foamTest::dict
            (
                "materials { steel { " + steel + " } } contactLaws {}"
                "walls { a { type plane; point (0 0 0); normal (0 1 0); material steel; " + left
              + "} b { type patches; patches (bottom); material steel; " + right + "} }"
            )
        );
        return grainWalls<2>(dict.subDict("walls"), space, grainMaterials(dict));
    };
    const grainWalls<2> none(walls("", ""));
    EXPECT_EQ(none.heated(), labelList({-1, -1}));
    const grainWalls<2> both(walls("temperature 300;", "temperature 300;"));
    EXPECT_EQ(both.heated().size(), 2);
    EXPECT_EQ(both.heatedNames(), wordList({"a", "b"}));
    for (const auto& wall : both.walls())
    {
        EXPECT_EQ(wall.material, 0);
    }
}


TEST(GrainHeat, IsAbsentWithoutItsDictionary)
{
    plate p("");
    p.dict.remove("heat");
    p.read();
    EXPECT_FALSE(p.heat);

    plate q("temperature 400;");
    q.dict.remove("heat");
    EXPECT_FOAM_ERROR(q.read(), "a dictionary 'heat'");
}


TEST(GrainHeat, RefusesWhatMakesNoSense)
{
    EXPECT_FOAM_ERROR(read("", "conductance magic;", steel), "rowOfSpheres spot squarePatch strip");
    EXPECT_FOAM_ERROR(read("", "x 1;", steel), "'x'");
    EXPECT_FOAM_ERROR(read("temperature -3;", "", steel), "a value > 0");
    EXPECT_FOAM_ERROR(read("temperature [1 0 0 0 0 0 0] 3;", "", steel), "dimensions");
    EXPECT_FOAM_ERROR(read("", "", "density 1;"), "conductivity");
    EXPECT_FOAM_ERROR(read("", "", "density 1; conductivity 0; youngsModulus 1;"), "conductivity");
    EXPECT_FOAM_ERROR(read("", "", "density 1; conductivity 1; youngsModulus 1;"), "heatCapacity");
    EXPECT_FOAM_ERROR(read("", "", steel + "poissonRatio 0.7;"), "from 0 to 0.5");

    plate p("");
    p.grains.temperature[0] = 0;
    EXPECT_FOAM_ERROR(p.read(), "grain 7 has the value 0");
}
