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


//- Of the mesh's faces, none if it does not move
surfaceScalarField throughFaces
(
    const volScalarField& epsByAlpha,
    const volScalarField& eps,
    const surfaceScalarField& phiAlpha
)
{
    surfaceScalarField flux
    (
        "phiEps", fvc::interpolate(epsByAlpha)*convectingFlux(phiAlpha)
    );
    if (phiAlpha.mesh().moving())
    {
        flux -= fvc::interpolate(eps)*phiAlpha.mesh().phi();
    }
    return flux;
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
    const surfaceScalarField& phiAlpha
)
:
    eps("epsFloored", max(grains.fluidShare, exchangeFields::epsMin)),
    epsOpen("epsOpen", grains.fluidShare + resolved.locked()),
    alpha(alphaOf(grains)),
    share(shareOf(grains, alpha)),
    bByShare("bByShare", grains.b/share),
    betaByShare("betaByShare", grains.beta/(alpha*share)),
    phib("phib", fvc::flux(bByShare)),
    betaf("betaf", fvc::interpolate(betaByShare)),
    phiEps(throughFaces(epsOpen/alpha, epsOpen, phiAlpha)),
    inertia("inertia", fluid.inertia(eps)),
    massFlux(fluid.massFlux(eps, phiEps)),
    mu("muEff", fluid.muStress()*viscosity.ratio(epsOpen)),
    muf("muf", fvc::interpolate(mu)),
    wallDrag(fluid.wallDrag()),
    faceForce(fluid.faceForce())
{}
