/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "foamTest.H"

#include "noResolvedTerm.H"
#include "vansFlow.H"
#include "weightOnFaces.H"

#include "fvc.H"
#include "pisoControl.H"

using namespace Foam;

namespace
{

//- Density with weight that falls along the height over that of the inertia,
//  which is uniform
class stratifiedFluid
:
    public carrier
{
    const volScalarField rho_;
    const volScalarField mu_;
    volScalarField rhoWeight_;
    const weightOnFaces weight_;

    static volScalarField uniform
    (
        const fvMesh& mesh,
        const word& name,
        const dimensionSet& dims,
        const scalar value
    )
    {
        return volScalarField
        (
            IOobject(name, mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(name, dims, value)
        );
    }

public:

    //- By a fifth over a length of one along gravity; on walls with its value
    //  there, or with that of the cell
    stratifiedFluid
    (
        const fvMesh& mesh,
        const dimensionedVector& g,
        const bool valueOnWalls
    )
    :
        rho_(uniform(mesh, "rho", dimDensity, 1000)),
        mu_(uniform(mesh, "mu", dimDynamicViscosity, 1e-3)),
        rhoWeight_(uniform(mesh, "rhoWeight", dimDensity, 0)),
        weight_(mesh, g)
    {
        const vector down(g.value()/mag(g.value()));
        const auto rho = [&](const vectorField& x)
        {
            return scalarField(1000 + 200*(down & x));
        };
        rhoWeight_.primitiveFieldRef() = rho(mesh.C().primitiveField());
        rhoWeight_.correctBoundaryConditions();
        for (fvPatchScalarField& patch : rhoWeight_.boundaryFieldRef())
        {
            if (!patch.coupled())
            {
                if (valueOnWalls)
                {
                    patch == rho(patch.patch().Cf());
                }
                else
                {
                    patch == scalarField(patch.patchInternalField());
                }
            }
        }
    }

    virtual const volScalarField& rho() const { return rho_; }

    virtual const volScalarField& rhoWeight() const { return rhoWeight_; }

    virtual const volScalarField& mu() const { return mu_; }

    virtual tmp<surfaceScalarField> faceForce() const
    {
        return weight_.force(rhoWeight_);
    }
};


//- Grains that do not move in the left half: 0.4 of the volume
void setBed(exchangeFields& grains, const scalar deltaT)
{
    const scalar w = 0.4, gamma = 1e5, rhoP = 2500;
    const scalar a = 1/(1 + gamma*deltaT/rhoP);
    const vectorField& x = grains.kappa.mesh().C().primitiveField();
    forAll(x, celli)
    {
        if (x[celli].x() < 0.5)
        {
            grains.fluidShare[celli] = 1 - w;
            grains.kappa[celli] = w*(1 - a);
            grains.beta[celli] = w*gamma*a;
            grains.K[celli] = w*a*deltaT/rhoP;
        }
    }
    grains.fluidShare.correctBoundaryConditions();
    grains.correctBoundaryConditions();
}


const std::string solution
(
    "solvers { \"p_rgh.*\" { solver PCG; preconditioner DIC; tolerance 1e-15; relTol 0; }"
    " U { solver PBiCGStab; preconditioner DILU; tolerance 1e-15; relTol 0; } }"
);

struct shape
{
    const char* name;
    foamTest::blockCase::map map;
    label nCorrectors;
    scalar bound;
};

const std::vector<shape>& shapes()
{
    static const std::vector<shape> all
    {
        {"Blocks", nullptr, 0, 1e-10},
        {
            // The slope of 30 degrees
            "Sheared",
            [](const point& x)
            {
                return point(x.x() + x.z()/Foam::sqrt(3.0), x.y(), x.z());
            },
            30, 1e-8
        },
        {
            // Cells of many shapes, whose faces are not plane
            "Waved",
            [](const point& x)
            {
                const scalar s = 0.04*std::sin(2*M_PI*x.x())
                   *std::sin(2*M_PI*x.y())*std::sin(2*M_PI*x.z());
                return x + s*vector(1, -1, 1);
            },
            30, 1e-8
        }
    };
    return all;
}


//- A field of the start; walls with the type given
std::string initial
(
    const std::string& type,
    const std::string& name,
    const std::string& dims,
    const std::string& value,
    const std::string& walls
)
{
    return
        "FoamFile { version 2.0; format ascii; class " + type + "; object " + name
      + "; } dimensions " + dims + "; internalField uniform " + value
      + "; boundaryField { \".*\" { type " + walls + "; } }";
}


class Stratified
:
    public ::testing::TestWithParam<std::tuple<label, bool, bool>>
{
protected:

    const shape shape_ = shapes()[std::get<0>(GetParam())];
    const bool tilted_ = std::get<1>(GetParam());

    //- Walls: fixedFluxPressure, with the density's value on them, or both
    //  without gradient
    const bool valueOnWalls_ = std::get<2>(GetParam());

    foamTest::blockCase case_
    {
        Vector<label>(8, 6, 8),
        boundBox(point::zero, point::one),
        shape_.map,
        "wall",
        "deltaT 1e-2; endTime 1e9; writeInterval 1000000;",
        solution + "PISO { nCorrectors 2; nNonOrthogonalCorrectors "
      + std::to_string(shape_.nCorrectors) + "; pRefCell 0; pRefValue 0; }"
    };
};


INSTANTIATE_TEST_SUITE_P
(
    Of, Stratified,
    ::testing::Combine
    (
        ::testing::Values(0, 1, 2), ::testing::Bool(), ::testing::Bool()
    ),
    [](const auto& info)
    {
        return
            std::string(shapes()[std::get<0>(info.param)].name)
          + (std::get<1>(info.param) ? "Tilted" : "")
          + (std::get<2>(info.param) ? "FluxPressure" : "ZeroGradient");
    }
);

}


TEST_P(Stratified, FluidStaysAtRestAmongGrains)
{
    fvMesh& mesh = case_.mesh();
    case_.writeFile
    (
        "0/p_rgh",
        initial
        (
            "volScalarField", "p_rgh", "[1 -1 -2 0 0 0 0]", "0",
            valueOnWalls_ ? "fixedFluxPressure; value uniform 0" : "zeroGradient"
        )
    );
    case_.writeFile
    (
        "0/U",
        initial("volVectorField", "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", "noSlip")
    );

    const dimensionedVector g
    (
        "g", dimAcceleration, 9.81*(tilted_ ? vector(0, -0.6, -0.8) : vector(0, 0, -1))
    );
    const stratifiedFluid fluid(mesh, g, valueOnWalls_);
    exchangeFields grains(mesh, true, 0);
    setBed(grains, case_.time().deltaTValue());
    const autoPtr<effectiveViscosity> viscosity(effectiveViscosity::New(dictionary()));
    noResolvedTerm resolved(mesh);
    pisoControl piso(mesh);
    vansFields fields(mesh);
    vansFlow flow(fields, fluid, viscosity(), grains, resolved, g, piso.dict());

    scalar worst = 0;
    for (label i = 0; i < 100; ++i)
    {
        case_.time()++;
        flow.startStep();
        flow.predict(piso);
        while (piso.correct())
        {
            flow.correct(piso);
        }
        worst = max(worst, gMax(mag(fields.U.primitiveField())()));
    }
    const scalar last = gMax(mag(fields.U.primitiveField())());
    RecordProperty("worst", std::to_string(worst));
    std::cout << "largest " << worst << ", last " << last << std::endl;
    EXPECT_LE(last, shape_.bound);

    // The pressure that holds the fluid is not nothing
    EXPECT_GE(gMax(fields.p_rgh.primitiveField()) - gMin(fields.p_rgh.primitiveField()), 100);
}
