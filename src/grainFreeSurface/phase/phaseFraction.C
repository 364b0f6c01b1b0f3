/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "phaseFraction.H"

#include "boundedCorrection.H"
#include "CMULES.H"
#include "fixedValueFvPatchFields.H"
#include "fluidInput.H"
#include "fvc.H"
#include "fvm.H"
#include "gaussConvectionScheme.H"
#include "gaussLaplacianScheme.H"
#include "upwind.H"
#include "tensionOnGrains.H"

namespace
{

using namespace Foam;

//- 1 on faces of a patch of given fraction through which fluid leaves, else 0:
//  it has the fraction of its cell
tmp<scalarField> leavesGivenFraction
(
    const surfaceScalarField& F,
    const volScalarField& alpha,
    const label patchi
)
{
    const fvPatchScalarField& patch = alpha.boundaryField()[patchi];
    return
        isA<fixedValueFvPatchScalarField>(patch)
      ? pos(F.boundaryField()[patchi] - VSMALL)
      : tmp<scalarField>(new scalarField(patch.size(), Zero));
}

}


Foam::phaseFraction::phaseFraction
(
    twoFluids& fluid,
    const grainSystem& grains,
    const volScalarField& eps,
    const volScalarField& locked,
    const dimensionedVector& g
)
:
    fluid_(fluid),
    grains_(grains),
    continued_(fluid.levels(), grains, g.value()),
    angles_(fluid.alpha()),
    nCorr_(readControl(fluid.alpha(), "nAlphaCorr", 1)),
    nSubCycles_(readControl(fluid.alpha(), "nAlphaSubCycles", 1)),
    liquid_(0),
    unaccounted_(0),
    broughtIn_(0),
    range_(0, 0)
{
    checkControls(fluid.alpha());
    for (const word scheme : {"div(rhoPhi,U)", "div(phi,alpha)", "div(phirb,alpha)"})
    {
        requireDivScheme(eps.mesh(), scheme);
    }
    eps.mesh().setFluxRequired(fluid.alpha().name());
    continued_.start(fluid.alpha(), eps, locked);
    angles_.restore(fluid.alpha());
    fluid.correct();
    continued_.correctSurface(fluid);
}


void Foam::phaseFraction::pullOnGrains(const volScalarField& locked)
{
    fluid_.setForceOnGrains(tensionOnGrains(fluid_, grains_, locked));
}


Foam::tmp<Foam::scalarField> Foam::phaseFraction::gas() const
{
    return pos(1e-6 - fluid_.alpha().primitiveField());
}


Foam::tmp<Foam::surfaceScalarField> Foam::phaseFraction::carryUpwind
(
    const transportFlux& flux,
    const surfaceScalarField& swap,
    const scalarField& before,
    const scalar deltaT
)
{
    volScalarField& alpha = fluid_.alpha();
    const fvMesh& mesh = alpha.mesh();
    const surfaceScalarField& F = flux.flux();

    // With the volume that the faces leave in a cell at the end of the step, which
    // its fraction has to 1e-12: a small cell's row adds up to what was in it
    tmp<fvScalarMatrix> tequation
    (
        fv::gaussConvectionScheme<scalar>
        (
            mesh, F, tmp<surfaceInterpolationScheme<scalar>>
            (
                new upwind<scalar>(mesh, F)
            )
        ).fvmDiv(F, alpha)
    );
    fvScalarMatrix& equation = tequation.ref();
    forAll(alpha.boundaryField(), patchi)
    {
        const scalarField leaves(leavesGivenFraction(F, alpha, patchi));
        equation.internalCoeffs()[patchi] +=
            leaves*(F.boundaryField()[patchi] - equation.internalCoeffs()[patchi]);
        equation.boundaryCoeffs()[patchi] *= 1 - leaves;
    }
    equation -= fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
    (
        swap, mesh.nonOrthDeltaCoeffs(), alpha
    );
    equation.diag() +=
        before/deltaT
      - fvc::surfaceIntegrate(F)().primitiveField()*mesh.V().field();
    equation.source() += before/deltaT*alpha.primitiveField();

    dictionary controls;
    controls.add("solver", "smoothSolver");
    controls.add("smoother", "symGaussSeidel");
    controls.add("tolerance", 1e-15);
    controls.add("relTol", 0);
    controls.add("maxIter", 100);
    equation.solve(controls);
    return equation.flux();
}


Foam::tmp<Foam::surfaceScalarField> Foam::phaseFraction::limitedFlux
(
    const surfaceScalarField& F
) const
{
    const word scheme("div(phi,alpha)");
    const word compression("div(phirb,alpha)");
    const volScalarField& alpha = fluid_.alpha();
    const volScalarField other(1.0 - alpha);
    const fvMesh& mesh = alpha.mesh();

    surfaceScalarField phir
    (
        fluid_.mixture().cAlpha()*mag(F/mesh.magSf())
       *fluid_.mixture().nHatf()
    );
    for (fvsPatchScalarField& patch : phir.boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch == 0;
        }
    }
    return
        fvc::flux(F, alpha, scheme)
      + fvc::flux
        (
           -fvc::flux(-phir, other, compression),
            alpha,
            compression
        );
}


void Foam::phaseFraction::correct
(
    const surfaceScalarField& F,
    const volScalarField::Internal& fraction,
    const scalar deltaT,
    const scalar relaxation,
    surfaceScalarField& alphaPhi
)
{
    volScalarField& alpha = fluid_.alpha();
    surfaceScalarField limited(limitedFlux(F));
    if (fluid_.levels().isNeeded())
    {
        fluid_.levels().limit(F, alpha, limited);
    }
    surfaceScalarField correction(limited - alphaPhi);
    if (continued_.isAny())
    {
        correction *= continued_.openFaces();
    }
    forAll(alpha.boundaryField(), patchi)
    {
        correction.boundaryFieldRef()[patchi] *=
            1 - leavesGivenFraction(F, alpha, patchi);
    }
    MULES::limitCorr
    (
        1/deltaT, fraction, alpha, limited, correction,
        zeroField(), zeroField(), oneField(), zeroField()
    );
    correction *= relaxation;
    boundCorrection(alpha, fraction, deltaT, correction);
    MULES::correct
    (
        1/deltaT, fraction, alpha, correction, zeroField(), zeroField()
    );
    alphaPhi += correction;
    continued_.apply(alpha);
}


void Foam::phaseFraction::advance
(
    const transportFlux& flux,
    const surfaceScalarField& swap,
    const scalarField& before,
    const scalarField& after,
    const scalar deltaT,
    surfaceScalarField& moved,
    scalarField& filled
)
{
    volScalarField& alpha = fluid_.alpha();
    const volScalarField::Internal fraction
    (
        IOobject("fraction", alpha.time().timeName(), alpha.mesh()),
        alpha.mesh(),
        dimless,
        after/alpha.mesh().V().field()
    );

    continued_.restore(alpha);
    surfaceScalarField alphaPhi(carryUpwind(flux, swap, before, deltaT));
    filled += deltaT*flux.source()*alpha.primitiveField();
    continued_.keep(alpha);
    continued_.apply(alpha);
    for (label i = 0; i < nCorr_; ++i)
    {
        continued_.correctSurface(fluid_);
        correct(flux.flux(), fraction, deltaT, i == 0 ? 1 : 0.5, alphaPhi);
    }
    angles_.keep(alpha);
    fluid_.correct();
    moved += alphaPhi*dimensionedScalar("deltaT", dimTime, deltaT);
}


void Foam::phaseFraction::carry
(
    const transportFlux& flux,
    const volScalarField& eps,
    const volScalarField& locked
)
{
    volScalarField& alpha = fluid_.alpha();
    const fvMesh& mesh = alpha.mesh();
    const scalar deltaT = mesh.time().deltaTValue();
    const scalarField& start = flux.oldVolume();
    const scalarField end(flux.volume());
    const scalarField massBefore
    (
        (start/mesh.V().field() + deltaT*flux.source())
       *fluid_.rho().primitiveField()
    );
    const scalar before = continued_.liquid(alpha, start);

    surfaceScalarField moved
    (
        IOobject("alphaMoved", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVolume, Zero)
    );
    moved.setOriented();
    scalarField filled(mesh.nCells(), Zero);
    continued_.update(alpha, eps, locked);
    const surfaceScalarField swap
    (
        continued_.swap(alpha, flux, locked)
    );
    for (label i = 0; i < nSubCycles_; ++i)
    {
        const scalar from = scalar(i)/nSubCycles_;
        const scalar to = scalar(i + 1)/nSubCycles_;
        advance
        (
            flux, swap, (1 - from)*start + from*end, (1 - to)*start + to*end,
            deltaT/nSubCycles_, moved, filled
        );
    }
    fluid_.setMass
    (
        massBefore, flux.flux(), moved/dimensionedScalar("deltaT", dimTime, deltaT)
    );

    // A contact angle and the fraction at its wall follow each other: as often as
    // in interFoam
    continued_.correctSurface(fluid_);

    liquid_ = continued_.liquid(alpha, end);
    broughtIn_ = gSum(filled*mesh.V().field());
    for (const fvsPatchScalarField& patch : moved.boundaryField())
    {
        if (!patch.coupled())
        {
            broughtIn_ -= gSum(patch);
        }
    }
    unaccounted_ = liquid_ - before - broughtIn_;
    range_ = continued_.range(alpha);
}


void Foam::phaseFraction::beforeMeshChange(const transportFlux& flux)
{
    volScalarField held("alphaHeld", fluid_.alpha());
    continued_.restore(held);

    // One at a time, as there is one name in the registry
    content_.clear();
    content_.reset
    (
        new volScalarField
        (
            IOobject
            (
                "alphaContent", flux.flux().time().timeName(),
                flux.flux().mesh()
            ),
            flux.fraction()*held
        )
    );
}


void Foam::phaseFraction::meshChanged
(
    const transportFlux& flux,
    const volScalarField& eps,
    const volScalarField& locked
)
{
    volScalarField& alpha = fluid_.alpha();
    fluid_.meshChanged();
    if (alpha.mesh().topoChanging())
    {
        alpha.primitiveFieldRef() =
            content_().primitiveField()/flux.fraction().primitiveField();
        continued_.restart(alpha, eps, locked);
    }
    continued_.apply(alpha);
    alpha.correctBoundaryConditions();
    content_.clear();
    fluid_.correct();
    continued_.correctSurface(fluid_);
}
