/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "continuedFraction.H"

#include "fvc.H"
#include "gaussLaplacianScheme.H"
#include "localMax.H"
#include "localMin.H"
#include "zeroGradientFvPatchFields.H"

Foam::continuedFraction::continuedFraction(const fvMesh& mesh, const vector& g)
:
    mesh_(mesh),
    down_(mag(g) > SMALL ? g/mag(g) : vector(Zero)),
    carried_
    (
        IOobject
        (
            "alphaOfCovered",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        mesh,
        dimensionedScalar("none", dimless, -1),
        zeroGradientFvPatchScalarField::typeName
    ),
    isAny_(false)
{}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::along() const
{
    // Across levels only what has no neighbour along its own
    constexpr scalar across = 1e-9;

    return max
    (
        1 - sqr((mesh_.Sf()/mesh_.magSf()) & down_), scalar(across)
    );
}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::swap
(
    const volScalarField& fraction,
    const volScalarField& locked
) const
{
    volScalarField volume
    (
        IOobject("fluidVolume", mesh_.time().timeName(), mesh_),
        mesh_,
        dimVolume,
        zeroGradientFvPatchScalarField::typeName
    );
    volume.primitiveFieldRef() = fraction.primitiveField()*mesh_.V().field();
    volume.correctBoundaryConditions();

    tmp<surfaceScalarField> tswap
    (
        along()*localMax<scalar>(mesh_).interpolate(locked)
       *localMin<scalar>(mesh_).interpolate(volume)
       /(mesh_.time().deltaT()*mesh_.nonOrthDeltaCoeffs())
    );
    for (fvsPatchScalarField& patch : tswap.ref().boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch == 0;
        }
    }
    return tswap;
}


void Foam::continuedFraction::findCovered(const volScalarField& eps)
{
    DynamicList<label> covered;
    forAll(eps, celli)
    {
        if (eps[celli] < covers)
        {
            covered.append(celli);
        }
    }
    covered_.transfer(covered);
    isAny_ = returnReduce(covered_.size() > 0, orOp<bool>());

    carried_.writeOpt() = isAny_ ? IOobject::AUTO_WRITE : IOobject::NO_WRITE;
    openFaces_.clear();
    if (isAny_)
    {
        openFaces_.reset
        (
            new surfaceScalarField
            (
                pos(fvc::interpolate(pos(eps - covers)) - (1 - SMALL))
            )
        );
    }
}


void Foam::continuedFraction::start
(
    const volScalarField& alpha,
    const volScalarField& eps
)
{
    findCovered(eps);
    for (const label celli : covered_)
    {
        if (carried_[celli] < 0)
        {
            carried_[celli] = alpha[celli];
        }
    }
}


void Foam::continuedFraction::restart
(
    const volScalarField& alpha,
    const volScalarField& eps
)
{
    findCovered(eps);
    keep(alpha);
}


void Foam::continuedFraction::update
(
    volScalarField& alpha,
    const volScalarField& eps
)
{
    restore(alpha);
    findCovered(eps);
    keep(alpha);
}


void Foam::continuedFraction::restore(volScalarField& alpha) const
{
    for (const label celli : covered_)
    {
        alpha[celli] = carried_[celli];
    }
}


void Foam::continuedFraction::keep(const volScalarField& alpha)
{
    for (const label celli : covered_)
    {
        carried_[celli] = alpha[celli];
    }
}


void Foam::continuedFraction::apply(volScalarField& alpha) const
{
    if (!isAny_)
    {
        return;
    }
    volScalarField continued
    (
        IOobject("alphaContinued", mesh_.time().timeName(), mesh_),
        mesh_,
        dimless,
        zeroGradientFvPatchScalarField::typeName
    );
    continued.primitiveFieldRef() = alpha.primitiveField();
    continued.correctBoundaryConditions();

    tmp<fvScalarMatrix> tequation
    (
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            along()*mesh_.magSf(), mesh_.nonOrthDeltaCoeffs(), continued
        )
    );
    labelList open(mesh_.nCells() - covered_.size());
    scalarField values(open.size());
    label openi = 0, coveredi = 0;
    forAll(continued, celli)
    {
        if (coveredi < covered_.size() && covered_[coveredi] == celli)
        {
            ++coveredi;
            continue;
        }
        open[openi] = celli;
        values[openi++] = continued[celli];
    }
    tequation.ref().setValues(open, values);

    dictionary controls;
    controls.add("solver", "PCG");
    controls.add("preconditioner", "DIC");
    controls.add("tolerance", 1e-13);
    controls.add("relTol", 0);
    tequation.ref().solve(controls);

    for (const label celli : covered_)
    {
        alpha[celli] = max(min(continued[celli], scalar(1)), scalar(0));
    }
    alpha.correctBoundaryConditions();
}


Foam::scalar Foam::continuedFraction::liquid
(
    const volScalarField& alpha,
    const scalarField& volume
) const
{
    scalar difference = 0;
    for (const label celli : covered_)
    {
        difference += (carried_[celli] - alpha[celli])*volume[celli];
    }
    return
        gSum(alpha.primitiveField()*volume)
      + returnReduce(difference, sumOp<scalar>());
}


Foam::Pair<Foam::scalar> Foam::continuedFraction::range
(
    const volScalarField& alpha
) const
{
    scalarField open(alpha.primitiveField());
    for (const label celli : covered_)
    {
        open[celli] = max(min(open[celli], scalar(1)), scalar(0));
    }
    return Pair<scalar>(gMin(open), gMax(open));
}
