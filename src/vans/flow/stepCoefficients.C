/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepCoefficients.H"

#include "byVolume.H"
#include "fvc.H"
#include "timeScheme.H"

namespace
{

using namespace Foam;

volScalarField shareOf(const exchangeFields& grains, const volScalarField& alpha)
{
    volScalarField share("share", alpha);
    if (!grains.gradientOnGrains)
    {
        share == dimensionedScalar("one", dimless, 1);
    }
    return share;
}


//- With what acts on the fluid of each cell, per volume; free patches have that of their
//  cells
template<class Type>
GeometricField<Type, fvPatchField, volMesh> withSource
(
    const word& name,
    const GeometricField<Type, fvPatchField, volMesh>& ofGrains,
    const labelHashSet& freePatches,
    const tmp<Field<Type>>& source
)
{
    GeometricField<Type, fvPatchField, volMesh> sum(name, ofGrains);
    if (source.valid())
    {
        sum.primitiveFieldRef() += source()/sum.mesh().V();
        sum.correctBoundaryConditions();
        for (const label patchi : freePatches)
        {
            fvPatchField<Type>& patch = sum.boundaryFieldRef()[patchi];
            patch == patch.patchInternalField();
        }
    }
    return sum;
}


tmp<scalarField> implicitPart(const fvVectorMatrix* sources)
{
    return
        sources && sources->hasDiag()
      ? -sources->diag()
      : tmp<scalarField>();
}


tmp<vectorField> explicitPart(const fvVectorMatrix* sources)
{
    return sources ? -sources->source() : tmp<vectorField>();
}


//- Of locked cells one, of others the other
template<class Field>
tmp<Field> inLocked(const resolvedTerm& resolved, const Field& locked, const Field& other)
{
    return resolved.locked()*locked + (1 - resolved.locked())*other;
}


//- Of the mesh's faces, none if it does not move
tmp<surfaceScalarField> throughFaces
(
    const volScalarField& eps,
    const vansFields& fields,
    const resolvedTerm& resolved
)
{
    surfaceScalarField velocity(convectingFlux(fields.phiU));
    if (eps.mesh().moving())
    {
        velocity -= eps.mesh().phi();
    }
    const surfaceScalarField epsf(fvc::interpolate(eps));
    return resolved.fluxOfVolume(epsf, velocity, convectingFlux(fields.phiOpen));
}

}


Foam::volScalarField Foam::stepCoefficients::alphaOf(const exchangeFields& grains)
{
    volScalarField alpha("alpha", grains.fluidShare + grains.kappa);
    forAll(alpha.boundaryField(), patchi)
    {
        if
        (
            !alpha.boundaryField()[patchi].coupled()
         && !grains.freePatches.found(patchi)
        )
        {
            alpha.boundaryFieldRef()[patchi] == 1;
        }
    }
    return alpha;
}


Foam::stepCoefficients::stepCoefficients
(
    const exchangeFields& grains,
    const resolvedTerm& resolved,
    const carrier& fluid,
    const effectiveViscosity& viscosity,
    const vansFields& fields,
    const fvVectorMatrix* sources
)
:
    eps("epsFloored", max(grains.fluidShare, exchangeFields::epsMin)),
    epsOpen("epsOpen", grains.fluidShare + resolved.locked()),
    alpha(alphaOf(grains)),
    share(shareOf(grains, alpha)),
    b(withSource("bOfStep", grains.b, grains.freePatches, explicitPart(sources))),
    beta
    (
        withSource
        (
            "betaOfStep", grains.beta, grains.freePatches, implicitPart(sources)
        )
    ),
    still("still", 1/(1 + grains.K*beta/(alpha*share))),
    bByShare
    (
        "bByShare",
        still*(b/share + grains.G*beta/(alpha*share))
    ),
    betaByShare
    (
        "betaByShare",
        resolved.leavesParts()
      ? still*beta*resolved.open()/(alpha*share)
      : still*beta/(alpha*share)
    ),
    phib
    (
        "phib",
        resolved.onFaces
        (
            fvc::flux(bByShare),
            fluxByVolume(inLocked(resolved, bByShare, grains.bBeside))
        )
    ),
    betaf
    (
        "betaf",
        resolved.onFaces
        (
            fvc::interpolate(betaByShare),
            byVolume(inLocked(resolved, betaByShare, grains.betaBeside))
        )
    ),
    phiEps("phiEps", throughFaces(epsOpen, fields, resolved)),
    inertia("inertia", fluid.inertia(eps)),
    massFlux(fluid.massFlux(eps, phiEps)),
    mu
    (
        "muEff",
        fluid.muStress()
       *viscosity.ratio(resolved.amongSmall(grains.fluidShare))
    ),
    muf("muf", fvc::interpolate(mu)),
    wallDrag(fluid.wallDrag()),
    faceForce(fluid.faceForce())
{}


void Foam::stepCoefficients::addForce(const volVectorField& force)
{
    const volVectorField byShare("byShare", still*force/share);
    b += force;
    bByShare += byShare;
    phib += fvc::flux(byShare);
}
