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
    const vansFields& fields
)
:
    eps("epsFloored", max(grains.fluidShare, exchangeFields::epsMin)),
    epsOpen("epsOpen", grains.fluidShare + resolved.locked()),
    alpha(alphaOf(grains)),
    share(shareOf(grains, alpha)),
    still("still", 1/(1 + grains.K*grains.beta/(alpha*share))),
    bByShare
    (
        "bByShare",
        still*(grains.b/share + grains.G*grains.beta/(alpha*share))
    ),
    betaByShare
    (
        "betaByShare",
        resolved.leavesParts()
      ? still*grains.beta*resolved.open()/(alpha*share)
      : still*grains.beta/(alpha*share)
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
