/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepCoefficients.H"

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
surfaceScalarField throughFaces
(
    const volScalarField& alpha,
    const volScalarField& eps,
    const vansFields& fields,
    const resolvedTerm& resolved
)
{
    surfaceScalarField flux
    (
        "phiEps",
        resolved.isPassable()
      ? fvc::interpolate(eps)*convectingFlux(fields.phiU)
      : resolved.onFaces
        (
            fvc::interpolate(eps/alpha)*convectingFlux(fields.phiAlpha),
            fvc::interpolate(eps)*convectingFlux(fields.phi)
        )
    );
    if (eps.mesh().moving())
    {
        flux -= fvc::interpolate(eps)*eps.mesh().phi();
    }
    return flux;
}


volScalarField stillShare
(
    const exchangeFields& grains,
    const resolvedTerm& resolved,
    const volScalarField& perFlux
)
{
    const scalar passes = resolved.isPassable() ? 1 : 0;
    return 1/(1 + passes*perFlux*grains.K);
}


volVectorField forceAtRest
(
    const exchangeFields& grains,
    const resolvedTerm& resolved,
    const volScalarField& share,
    const volScalarField& perFlux
)
{
    if (!resolved.isPassable())
    {
        return grains.b/share;
    }
    return grains.b/share + perFlux*grains.G;
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
    still
    (
        "still",
        stillShare(grains, resolved, grains.beta/(alpha*share))
    ),
    bByShare
    (
        "bByShare",
        still*forceAtRest(grains, resolved, share, grains.beta/(alpha*share))
    ),
    betaByShare("betaByShare", still*grains.beta/(alpha*share)),
    phib
    (
        "phib",
        resolved.onFaces
        (
            fvc::flux(bByShare),
            fvc::flux(inLocked(resolved, bByShare, grains.bBeside))
        )
    ),
    betaf
    (
        "betaf",
        resolved.onFaces
        (
            fvc::interpolate(betaByShare),
            fvc::interpolate(inLocked(resolved, betaByShare, grains.betaBeside))
        )
    ),
    phiEps(throughFaces(alpha, epsOpen, fields, resolved)),
    inertia("inertia", fluid.inertia(eps)),
    massFlux(fluid.massFlux(eps, phiEps)),
    mu
    (
        "muEff",
        fluid.muStress()
       *viscosity.ratio(epsOpen + (1 - resolved.open() - resolved.locked()))
    ),
    muf("muf", fvc::interpolate(mu)),
    wallDrag(fluid.wallDrag()),
    faceForce(fluid.faceForce())
{}
