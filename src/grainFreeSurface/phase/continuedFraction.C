/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "continuedFraction.H"

#include "fvc.H"
#include "gaussLaplacianScheme.H"
#include "localMax.H"
#include "localMin.H"
#include "uncorrectedSnGrad.H"
#include "zeroGradientFvPatchFields.H"

Foam::continuedFraction::continuedFraction
(
    const surfaceLevels& levels,
    const grainSystem& grains,
    const vector& g
)
:
    mesh_(grains.mesh()),
    levels_(levels),
    wetting_(grains),
    isFixed_(grains.motion().isFixed()),
    g_("g", dimAcceleration, mag(g)),
    down_(mag(g) > SMALL ? g/mag(g) : vector(Zero)),
    carried_
    (
        IOobject
        (
            "alphaOfCovered",
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", dimless, -1),
        zeroGradientFvPatchScalarField::typeName
    ),
    isAny_(false)
{}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::along() const
{
    // Of faces across levels, no more than round-off
    const surfaceScalarField share
    (
        1 - sqr((mesh_.Sf()/mesh_.magSf()) & down_)
    );
    return share*pos(share - scalar(across));
}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::swap
(
    const volScalarField& alpha,
    const transportFlux& flux,
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
    volume.primitiveFieldRef() = flux.volume();
    volume.correctBoundaryConditions();

    volScalarField carried("carriedByGrains", 0*volume);
    carried.primitiveFieldRef() =
        0.5*mesh_.time().deltaTValue()*locked.primitiveField()
       *fvc::surfaceSum(mag(flux.flux()))().primitiveField();
    carried.correctBoundaryConditions();

    const surfaceScalarField& perDistance = mesh_.nonOrthDeltaCoeffs();
    const surfaceScalarField least(localMin<scalar>(mesh_).interpolate(volume));
    tmp<surfaceScalarField> tswap
    (
        along()*localMax<scalar>(mesh_).interpolate(locked)
       *min
        (
            least,
            exchanges*localMax<scalar>(mesh_).interpolate(carried)
          + mesh_.time().deltaT()*sqrt(g_*perDistance)*least
        )
       /(mesh_.time().deltaT()*perDistance)
    );
    if (isFixed_)
    {
        tswap.ref() *= scalar(0);
    }
    if (levels_.isNeeded())
    {
        tswap.ref() *= offLevel(alpha, localMax<scalar>(mesh_).interpolate(locked));
    }
    for (fvsPatchScalarField& patch : tswap.ref().boundaryFieldRef())
    {
        if (!patch.coupled())
        {
            patch == 0;
        }
    }
    return tswap;
}


void Foam::continuedFraction::findCovered
(
    const volScalarField& eps,
    const volScalarField& locked
)
{
    volScalarField open
    (
        IOobject("open", mesh_.time().timeName(), mesh_),
        mesh_,
        dimless,
        zeroGradientFvPatchScalarField::typeName
    );
    open.primitiveFieldRef() =
        pos(eps.primitiveField() - covers)*pos(0.5 - locked.primitiveField());
    open.correctBoundaryConditions();
    DynamicList<label> covered;
    forAll(open, celli)
    {
        if (open[celli] < 0.5)
        {
            covered.append(celli);
        }
    }
    covered_.transfer(covered);

    DynamicList<label> cut;
    DynamicList<scalar> ownPart;
    forAll(open, celli)
    {
        if (open[celli] < 0.5 || eps[celli] < 1 - SMALL)
        {
            cut.append(celli);
            ownPart.append(open[celli] < 0.5 ? 0 : eps[celli]);
        }
    }
    cut_.transfer(cut);
    ownPart_.transfer(ownPart);
    isAny_ = returnReduce(covered_.size() > 0, orOp<bool>());

    carried_.writeOpt() = isAny_ ? IOobject::AUTO_WRITE : IOobject::NO_WRITE;
    openFaces_.clear();
    if (isAny_)
    {
        openFaces_.reset
        (
            new surfaceScalarField
            (
                pos(fvc::interpolate(open) - (1 - SMALL))
            )
        );
    }
}


void Foam::continuedFraction::start
(
    volScalarField& alpha,
    const volScalarField& eps,
    const volScalarField& locked
)
{
    // Where grains locked cells when a run was stopped is known from what was kept
    carried_.correctBoundaryConditions();
    findCovered(eps, max(locked, pos0(carried_)));
    bool isKnown = true;
    for (const label celli : covered_)
    {
        if (carried_[celli] < 0)
        {
            isKnown = false;
            carried_[celli] = alpha[celli];
        }
    }
    if (!returnReduce(isKnown, andOp<bool>()))
    {
        apply(alpha);
    }
}


void Foam::continuedFraction::restart
(
    const volScalarField& alpha,
    const volScalarField& eps,
    const volScalarField& locked
)
{
    findCovered(eps, locked);
    keep(alpha);
}


void Foam::continuedFraction::update
(
    volScalarField& alpha,
    const volScalarField& eps,
    const volScalarField& locked
)
{
    restore(alpha);
    findCovered(eps, locked);
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
    carried_ == dimensionedScalar("none", dimless, -1);
    for (const label celli : covered_)
    {
        carried_[celli] = alpha[celli];
    }
}


void Foam::continuedFraction::confine
(
    const boolList& isIn,
    fvScalarMatrix& equation
) const
{
    const scalarField& given = equation.psi().primitiveField();
    DynamicList<label> others(mesh_.nCells());
    DynamicList<scalar> values(mesh_.nCells());
    forAll(given, celli)
    {
        if (!isIn[celli])
        {
            others.append(celli);
            values.append(given[celli]);
        }
    }
    // setValues leaves nothing of a cell all of whose neighbours are elsewhere
    scalarField& diagonal = equation.diag();
    const scalar typical = gAverage(diagonal);
    for (const label celli : others)
    {
        if (diagonal[celli] == 0)
        {
            diagonal[celli] = typical;
        }
    }
    equation.setValues(others, values);
}


void Foam::continuedFraction::solveCovered(fvScalarMatrix& equation) const
{
    boolList isCovered(mesh_.nCells(), false);
    for (const label celli : covered_)
    {
        isCovered[celli] = true;
    }
    dictionary controls;
    controls.add("solver", "PCG");
    controls.add("preconditioner", "DIC");
    controls.add("tolerance", tolerance);
    controls.add("relTol", 0);
    confine(isCovered, equation);
    equation.solve(controls);
}


void Foam::continuedFraction::solve
(
    const surfaceScalarField& weight,
    const surfaceScalarField& takenBack,
    volScalarField& continued
) const
{
    tmp<fvScalarMatrix> tequation
    (
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            weight*mesh_.magSf(), mesh_.nonOrthDeltaCoeffs(), continued
        )
    );
    fvScalarMatrix& equation = tequation.ref();
    const surfaceScalarField flux
    (
        takenBack*mesh_.magSf()
       *fv::uncorrectedSnGrad<scalar>(mesh_).snGrad(continued)
    );
    equation.source() +=
        mesh_.V()*fvc::surfaceIntegrate(flux)().primitiveField();

    solveCovered(equation);
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

    // What passes across levels is taken back, so that it is left only where a
    // level is covered from wall to wall
    const surfaceScalarField alongLevels(max(along(), scalar(across)));
    solve(alongLevels, surfaceScalarField(0*alongLevels), continued);
    solve(alongLevels, pos(2*across - alongLevels)*alongLevels, continued);

    if (levels_.isNeeded())
    {
        continueLevels(alpha, continued);
    }
    if (wetting_.isAny())
    {
        const scalarField straight(mesh_.nCells(), Zero);
        continueAngles(covered_, straight, continued);
    }
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
