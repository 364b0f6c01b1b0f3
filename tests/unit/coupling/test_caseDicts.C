/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "contactLaw.H"
#include "effectiveConductivity.H"
#include "grainHeat.H"
#include "grainMaterials.H"
#include "grainOutlet.H"
#include "grainShapes.H"
#include "heatLaw.H"
#include "IFstream.H"
#include "thermalFluid.H"
#include "wallMotion.H"

#include <fstream>
#include <sstream>

using namespace Foam;

namespace
{

dictionary documented(const std::string& name)
{
    return dictionary(IFstream(fileName(GRAINFOAM_SRC "/../etc/caseDicts/" + name))());
}

}


TEST(CaseDicts, OfGrainPropertiesAreAccepted)
{
    foamTest::planarCase planar(2, 2);
    const grainSpace<2> space(planar.mesh());
    const dictionary dict(documented("grainProperties"));

    const grainMaterials materials(dict);
    EXPECT_EQ(materials.contactTable()(0, 0).restitution, 0.5);
    EXPECT_EQ(materials.contactTable()(0, 1).tension, 0.1);

    label nMoving = 0;
    for (const word& name : dict.subDict("walls").toc())
    {
        const dictionary& wall = dict.subDict("walls").subDict(name);
        EXPECT_GE(materials.index(wall, "material"), 0) << name;
        if (wall.found("motion"))
        {
            // A patch of this mesh in the place of the one that the example has
            dictionary one(wall);
            one.set("patches", wordList({"left"}));
            EXPECT_NO_THROW(wallMotion<2>::New(one.subDict("motion"), space)) << name;
            ++nMoving;
        }
    }
    EXPECT_EQ(nMoving, 6);

    dictionary walls;
    walls.add("box", dict.subDict("walls").subDict("box"));
    const auto heat =
        grainHeat<2>::New(dict, space, materials, grainWalls<2>(walls, space, materials));
    EXPECT_TRUE(heat);

    const dictionary& outlets = dict.subDict("outlets");
    for (const word& name : outlets.toc())
    {
        EXPECT_NO_THROW(grainOutlet<2>::New(outlets.subDict(name), space)) << name;
    }
    EXPECT_EQ(outlets.size(), 3);

    const grainShapes<2> shapes(dict, space);
    EXPECT_EQ(shapes.names(), wordList({"rod", "disc"}));
    EXPECT_EQ(shapes.find("rod"), 0);
    EXPECT_EQ(shapes.find("disc"), -1);
}


TEST(CaseDicts, OfHeatTransferAreAccepted)
{
    const dictionary coupling(documented("grainProperties").subDict("coupling"));
    const autoPtr<heatLaw> law(heatLaw::New(coupling.subDict("heatTransfer"), 2));
    EXPECT_EQ(law->type(), "Henry");
    EXPECT_EQ(effectiveConductivity::New(coupling, 2)->type(), "ZehnerSchluender");
    EXPECT_EQ(effectiveConductivity::New(coupling, 2, "diffusivity")->type(), "Maxwell");

    // Its comment names every law
    std::stringstream text;
    text << std::ifstream(GRAINFOAM_SRC "/../etc/caseDicts/grainProperties").rdbuf();
    for (const word& type : heatLaw::dictionaryConstructorTablePtr_->sortedToc())
    {
        EXPECT_NE(text.str().find(type), std::string::npos) << type;
    }
}


TEST(CaseDicts, OfTransportPropertiesAreThoseOfAFluidWithHeat)
{
    foamTest::planarCase planar(2, 2);
    std::stringstream text;
    text << std::ifstream(GRAINFOAM_SRC "/../etc/caseDicts/transportProperties").rdbuf();
    planar.writeFile("constant/transportProperties", text.str());

    const fvMesh& mesh = planar.mesh();
    const auto io = [&](const word& name)
    {
        return IOobject(name, mesh.time().timeName(), mesh);
    };
    const volVectorField U(io("U"), mesh, dimensionedVector(dimVelocity, Zero));
    const surfaceScalarField phiU
    (
        io("phiU"), mesh, dimensionedScalar(dimVelocity*dimArea, Zero)
    );
    const volScalarField T(io("T"), mesh, dimensionedScalar("T", dimTemperature, 303));
    const thermalFluid fluid
    (
        U, phiU, T, dimensionedVector("g", dimAcceleration, vector(0, -9.81, 0))
    );

    // Warmer by 10 K than TRef
    EXPECT_NEAR(fluid.capacity(), 1000*4180, 1e-6);
    EXPECT_NEAR(fluid.kappa()[0], 0.6, 1e-12);
    EXPECT_NEAR(fluid.rhoWeight()[0], 1000*(1 - 2e-4*10), 1e-9);
    EXPECT_NEAR(fluid.plates().coefficient(), 2*350/0.02, 1e-9);
    EXPECT_NEAR(fluid.plates().temperature(), 290, 1e-12);
}


TEST(GrainShapes, AreScaledToRadiusOne)
{
    // Two discs side by side: area 2 pi r^2 of r = 1/2
    foamTest::planarCase planar(1, 1);
    const grainSpace<2> space(planar.mesh());
    const grainShapes<2> shapes
    (
        foamTest::dict("shapes { pair { type cluster; centres ((0 0 0) (0 6 0)); radii (3 3); } }"),
        space
    );
    ASSERT_EQ(shapes.clusters().size(), 1u);
    EXPECT_NEAR(shapes.clusters()[0].volume, constant::mathematical::pi/2, 1e-6);

    nscd::Grains<2> grains;
    grains.resize(2);
    grains.clusters = shapes.clusters();
    grains.radius = {0.2, 0.2};
    grains.shape = {0, -1};
    EXPECT_NEAR(space.volume(grains, 0)/space.volume(grains, 1), 0.5, 1e-6);
}


TEST(GrainShapes, RefuseWhatMakesNoSense)
{
    foamTest::planarCase planar(1, 1);
    const grainSpace<2> space(planar.mesh());
    const auto shapes = [&](const std::string& entries)
    {
        return grainShapes<2>(foamTest::dict("shapes { a { " + entries + " } }"), space);
    };
    EXPECT_FOAM_ERROR(shapes("type cube;"), "cluster");
    EXPECT_FOAM_ERROR(shapes("type cluster; centres ((0 0 0)); radii (1 1);"), "as many radii");
    EXPECT_FOAM_ERROR(shapes("type cluster; centres ((0 0 0)); radii (-1);"), "radii > 0");
    EXPECT_FOAM_ERROR(shapes("type cluster; centres ((0 0 0)); radii (1); x 1;"), "'x'");
    EXPECT_FOAM_ERROR
    (
        grainShapes<2>(dictionary(), space).index(foamTest::dict("shape rod;")), "disc"
    );
}


TEST(Orientation, IsTheSameInSpace)
{
    foamTest::planarCase planar(1, 1);
    const grainSpace<2> space(planar.mesh());
    for (const double angle : {0.0, 0.3, -2.0, 3.0})
    {
        const nscd::Orientation<2> o(angle);
        const quaternion q(space.orientationInSpace(o));
        EXPECT_NEAR(space.orientationFromSpace(q).angle(), angle, 1e-14);

        const nscd::Vector<2> x(0.2, 0.7);
        EXPECT_NEAR(mag(q.transform(space.toSpace(x)) - space.toSpace(o*x)), 0, 1e-14);
    }
}
