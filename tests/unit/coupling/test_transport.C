/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "fluidScalar.H"
#include "mathematicalConstants.H"
#include "planarCells.H"
#include "periodicCells.H"
#include "spatialCells.H"
#include "voidFractionMethod.H"

#include "fvc.H"

#include <random>

using namespace Foam;

namespace
{

const std::string solvers
(
    "solvers { dye { solver PBiCGStab; preconditioner DILU; tolerance 1e-15;"
    " relTol 0; maxIter 200; } }"
);

const std::string upwind
(
    "ddtSchemes { default Euler; }"
    "gradSchemes { default Gauss linear; }"
    "divSchemes { default Gauss upwind; }"
    "laplacianSchemes { default Gauss linear corrected; }"
    "interpolationSchemes { default linear; }"
    "snGradSchemes { default corrected; }"
);

//- Steps of each run: GRAINFOAM_TEST_STEPS, or a few
label nSteps()
{
    const char* given = std::getenv("GRAINFOAM_TEST_STEPS");
    return given ? std::atoi(given) : 60;
}


//- A grain that goes at random through cells with a scalar in them, the box
//  closed or with an opening: dimension, diameter in cells, is it open?
class Carried
:
    public ::testing::TestWithParam<std::tuple<label, scalar, bool>>
{
protected:

    const bool planar_ = std::get<0>(GetParam()) == 2;

    const bool open_ = std::get<2>(GetParam());

    //- Cells per side of a cube of side 1
    const label n_ = planar_ ? 24 : 14;

    const scalar h_ = 1.0/n_;

    const scalar radius_ = 0.5*std::get<1>(GetParam())*h_;

    std::mt19937 random_{17};

    foamTest::blockCase case_
    {
        Vector<label>(n_, n_, planar_ ? 1 : n_),
        boundBox(point::zero, point::one),
        nullptr,
        planar_ ? "empty" : "wall",
        "deltaT 1; endTime 1e9;",
        solvers
    };

    const fvMesh& mesh_ = case_.mesh();

    std::unique_ptr<planarMesh> plane_
    {
        planar_ ? new planarMesh(mesh_) : nullptr
    };

    std::unique_ptr<grainCells> cells_
    {
        planar_
      ? static_cast<grainCells*>(new planarCells(*plane_))
      : new spatialCells(mesh_)
    };

    const autoPtr<voidFractionMethod> method_
    {
        voidFractionMethod::New(foamTest::dict("type exactOverlap;"), *cells_)
    };

    point x_{0.5, 0.5, 0.5};

    scalar uniform(const scalar low, const scalar high)
    {
        return std::uniform_real_distribution<scalar>(low, high)(random_);
    }

    //- By at most half a cell in each direction
    void moveGrain()
    {
        for (direction d = 0; d < (planar_ ? 2 : 3); ++d)
        {
            x_[d] += uniform(-0.5, 0.5)*h_;
            x_[d] = min(max(x_[d], radius_), 1 - radius_);
        }
    }

    void setEps(volScalarField& eps) const
    {
        const grainBodies grain
        {
            pointField(1, x_), scalarField(1, radius_), labelList({0, 1}),
            List<grainMember>(1, grainMember{x_, radius_})
        };
        overlapList overlaps;
        overlaps.clear();
        method_->map(grain, overlaps);
        eps.primitiveFieldRef() = 1;
        for (const cellOverlap& o : overlaps.all())
        {
            eps[o.cell] -= o.volume/mesh_.V()[o.cell];
        }
        eps.max(0);
        eps.correctBoundaryConditions();
    }

    volScalarField field(const word& name, const wordList& patchTypes) const
    {
        return volScalarField
        (
            IOobject(name, mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(dimless, Zero),
            patchTypes
        );
    }

    //- Fixed at the right if the box is open
    wordList pressurePatches() const
    {
        wordList types(mesh_.boundary().size(), "zeroGradient");
        if (open_)
        {
            types[mesh_.boundary().findPatchID("right")] = "fixedValue";
        }
        return types;
    }

    void writeDye() const
    {
        case_.writeFile
        (
            "system/fvSchemes",
            "FoamFile { version 2.0; format ascii; class dictionary; object fvSchemes; }"
          + upwind
        );
        const std::string sides = planar_ ? "{ type empty; }" : "{ type zeroGradient; }";
        case_.writeFile
        (
            "0/dye",
            "FoamFile { version 2.0; format ascii; class volScalarField; object dye; }"
            "dimensions [0 0 0 0 0 0 0]; internalField uniform 0; boundaryField {"
            "front " + sides + " back " + sides
          + " \".*\" { type zeroGradient; }"
            " right { type inletOutlet; phi phiFluid; inletValue uniform 0.5; value uniform 0.5; }"
            "}"
        );
    }

    //- A random vortex that moves fluid by up to half a cell in a step, [m^3/s]
    surfaceScalarField vortex()
    {
        const scalar k = constant::mathematical::pi;
        const scalar speed = uniform(-0.5, 0.5)*h_;
        volVectorField U
        (
            IOobject("U", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(dimVelocity, Zero)
        );
        forAll(U, celli)
        {
            const point& x = mesh_.C()[celli];
            U[celli] = speed*vector
            (
                std::sin(k*x.x())*std::cos(k*x.y()),
               -std::cos(k*x.x())*std::sin(k*x.y()),
                0
            );
        }
        return fvc::flux(U);
    }
};

INSTANTIATE_TEST_SUITE_P
(
    Of, Carried,
    ::testing::Combine
    (
        ::testing::Values(2, 3),
        ::testing::Values(0.2, 1.3, 4.3, 10.0),
        ::testing::Bool()
    ),
    [](const auto& info)
    {
        const label d = label(10*std::get<1>(info.param));
        return std::string(std::get<0>(info.param) == 2 ? "Disc" : "Sphere")
          + std::to_string(d) + (std::get<2>(info.param) ? "InOpenBox" : "InClosedBox");
    }
);

}


TEST_P(Carried, IsKeptAndBounded)
{
    writeDye();
    static_cast<fvSchemes&>(case_.mesh()).read();

    volScalarField eps(field("eps", wordList(mesh_.boundary().size(), "zeroGradient")));
    setEps(eps);
    const volScalarField p(field("p_rgh", pressurePatches()));
    transportFlux flux(eps, vortex(), p);
    fluidScalar dye(mesh_, "dye");
    const dimensionedScalar D("D", dimViscosity, 0);
    volScalarField& T = const_cast<volScalarField&>(dye.field());
    for (scalar& value : T.primitiveFieldRef())
    {
        value = uniform(0, 1);
    }
    T.correctBoundaryConditions();

    // Initial values are between zero and one, and so is that of fluid that comes in
    scalar amount = dye.integral(flux);
    scalar worst = 0;
    const scalarField none(mesh_.nCells(), Zero);
    for (label i = 0; i < nSteps(); ++i)
    {
        case_.time()++;
        flux.startStep();
        const surfaceScalarField share(fvc::interpolate(eps)*vortex());
        moveGrain();
        setEps(eps);
        flux.set(share, none);
        dye.carry(flux, D*fvc::interpolate(flux.fraction()));

        ASSERT_LE(flux.defect(), 1e-12);
        worst = max(worst, mag(dye.unaccounted())/amount);
        ASSERT_GE(min(T.primitiveField()), -1e-12);
        ASSERT_LE(max(T.primitiveField()), 1 + 1e-12);
    }
    EXPECT_LE(worst, 1e-12);
    if (!open_)
    {
        EXPECT_NEAR(dye.integral(flux)/amount, 1, 1e-12);
    }
}
