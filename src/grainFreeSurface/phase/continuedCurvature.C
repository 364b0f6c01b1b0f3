/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "continuedFraction.H"

#include "fvc.H"
#include "gaussLaplacianScheme.H"
#include "localMin.H"
#include "spreadToNeighbours.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

volScalarField ofCells(const fvMesh& mesh, const word& name)
{
    return volScalarField
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
}

}


Foam::tmp<Foam::volScalarField> Foam::continuedFraction::continuedTension
(
    const twoFluids& fluid
) const
{
    // Cells along the surface over which it is averaged, and share of cells without
    constexpr scalar length = 2, least = 1e-6;

    // Beyond this number of cells from a grain no curvature knows of it
    constexpr label reach = 2;

    volScalarField near(ofCells(mesh_, "nearGrains"));
    for (const label celli : cut_)
    {
        near[celli] = 1;
    }
    for (label i = 0; i < reach; ++i)
    {
        spreadToNeighbours(near);
    }

    const scalarField alpha
    (
        max(min(fluid.alpha().primitiveField(), scalar(1)), scalar(0))
    );
    volScalarField surface(ofCells(mesh_, "atSurface"));
    surface.primitiveFieldRef() = 4*alpha*(1 - alpha);
    surface.correctBoundaryConditions();

    tmp<volScalarField> tresult(fluid.mixture().sigmaK());
    const volScalarField own(tresult());
    volScalarField x(ofCells(mesh_, "tensionContinued"));
    x.dimensions().reset(own.dimensions());
    x.primitiveFieldRef() = own.primitiveField()*(1 - near.primitiveField());

    tmp<fvScalarMatrix> tequation
    (
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            sqr(length)*(localMin<scalar>(mesh_).interpolate(surface) + least)
           *mesh_.magSf()/sqr(mesh_.nonOrthDeltaCoeffs()),
            mesh_.nonOrthDeltaCoeffs(), x
        )
    );
    fvScalarMatrix& equation = tequation.ref();
    const scalarField counts
    (
        surface.primitiveField()*(1 - near.primitiveField())*mesh_.V().field()
    );
    equation.diag() -= counts + sqr(least)*mesh_.V().field();
    equation.source() -= counts*own.primitiveField();

    dictionary controls;
    controls.add("solver", "PCG");
    controls.add("preconditioner", "DIC");
    controls.add("tolerance", 1e-12);
    controls.add("relTol", 0);
    equation.solve(controls);

    tresult.ref() = x;
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::tensionOfFaces
(
    const twoFluids& fluid
)
{
    // Between cells that are both without a surface it is the mean
    constexpr scalar least = 1e-4;

    const scalarField alpha
    (
        max(min(fluid.alpha().primitiveField(), scalar(1)), scalar(0))
    );
    volScalarField weight(ofCells(fluid.alpha().mesh(), "atSurface"));
    weight.primitiveFieldRef() = max(sqrt(alpha*(1 - alpha)), least);
    weight.correctBoundaryConditions();
    return
        fvc::interpolate(weight*fluid.mixture().sigmaK())
       /fvc::interpolate(weight);
}


void Foam::continuedFraction::bend
(
    const scalarField& held,
    const scalarField& curvature,
    twoFluids& fluid
) const
{
    volScalarField& alpha = fluid.alpha();
    volScalarField continued
    (
        IOobject("alphaContinued", mesh_.time().timeName(), mesh_),
        mesh_,
        dimless,
        zeroGradientFvPatchScalarField::typeName
    );
    continued.primitiveFieldRef() = held;
    continueAngles(cut_, curvature, continued);
    forAll(cut_, i)
    {
        const label celli = cut_[i];
        alpha[celli] =
            ownPart_[i]*held[celli]
          + (1 - ownPart_[i])*max(min(continued[celli], scalar(1)), scalar(0));
    }
    alpha.correctBoundaryConditions();
    fluid.correctSurface();
}


void Foam::continuedFraction::correctSurface(twoFluids& fluid) const
{
    if (!wetting_.isAny())
    {
        fluid.correctSurface();
        return;
    }
    volScalarField& alpha = fluid.alpha();
    const scalarField held(alpha.primitiveField());
    scalarField curvature(mesh_.nCells(), Zero);
    bend(held, curvature, fluid);

    const scalarField sigma(fluid.sigma()().primitiveField());
    if (gMax(sigma) > 0)
    {
        // Half of it for each of two directions
        curvature =
            continuedTension(fluid)().primitiveField()
           /max(sigma, VSMALL)/(mesh_.nGeometricD() - 1);
        bend(held, curvature, fluid);
    }

    const surfaceScalarField tension(tensionOfFaces(fluid));

    // It balances the pressure of what is there, whose density that is
    alpha.primitiveFieldRef() = held;
    alpha.correctBoundaryConditions();
    fluid.keepTension(tension);
}
