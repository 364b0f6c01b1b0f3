/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceMomentum.H"

#include "fvc.H"

namespace
{

using namespace Foam;

//- Before or after the last transport of the fluid
tmp<volScalarField> leastInertia
(
    const stepCoefficients& step,
    const volScalarField& rho
)
{
    return min(step.inertia, step.eps*rho);
}


tmp<volScalarField> leastA
(
    const stepCoefficients& step,
    const volScalarField& rho
)
{
    tmp<volScalarField> tleast(leastInertia(step, rho)/rho.time().deltaT());
    if (step.wallDrag.valid())
    {
        return tleast + step.eps*step.wallDrag();
    }
    return tleast;
}


//- OpenFOAM's limiter of what a flux differs from that of its cells by, between
//  cells of two fluids; 1 between others
tmp<surfaceScalarField> limiterBetweenFluids
(
    const surfaceScalarField& flux,
    const surfaceScalarField& difference,
    const volScalarField& rho
)
{
    surfaceScalarField jump
    (
        mag(fvc::snGrad(rho))
       /(rho.mesh().deltaCoeffs()*fvc::interpolate(rho))
    );
    jump.setOriented(false);
    surfaceScalarField excess
    (
        min
        (
            mag(difference)
           /(mag(flux) + dimensionedScalar("small", flux.dimensions(), VSMALL)),
            scalar(1)
        )
    );
    excess.setOriented(false);
    return 1 - pos(jump - 1e-3)*excess;
}


//- Share of the volume that moves with what the face does, times the share of the
//  pressure gradient that moves it
tmp<volScalarField> shareOf
(
    const stepCoefficients& step,
    const exchangeFields& grains
)
{
    tmp<volScalarField> moves(step.alpha + grains.mobile);
    return grains.gradientOnGrains ? sqr(moves) : moves;
}


//- Flux of a face less that of its cells, each by its part in the equation of the
//  face, at the beginning of the step, per time
tmp<surfaceScalarField> changeOfOldFlux
(
    const faceMomentum& faces,
    const stepCoefficients& step,
    const resolvedTerm& resolved,
    const volVectorField& U,
    const volScalarField& rho,
    const surfaceScalarField& phi
)
{
    const dimensionedScalar& deltaT = rho.time().deltaT();
    const surfaceScalarField ofBoth(faces.ofFaces(step.alpha));
    const auto ofCells = [&](const volVectorField& u)
    {
        return faces.fluxOfFaces(step.alpha*u)/ofBoth;
    };
    if (resolved.isActive())
    {
        // Drag and viscosity bring the flux of a face to that of its cells.  With
        // OpenFOAM's limiter in their place the drag of narrow gaps depends on
        // the time step (doc/theory, eq. 3.14).
        const surfaceScalarField difference
        (
            phi.oldTime() - ofCells(U.oldTime())
        );
        return
            limiterBetweenFluids(phi.oldTime(), difference, rho)
           *fvc::interpolate(leastInertia(step, rho)/(faces.A*deltaT))
           *difference/deltaT;
    }

    // The same difference for OpenFOAM, which takes the mean of the cells
    surfaceScalarField toMean("toMean", phi);
    const auto shift = [&](surfaceScalarField& flux, const volVectorField& u)
    {
        flux += fvc::flux(u) - ofCells(u);
    };
    shift(toMean.oldTime(), U.oldTime());
    if (toMean.nOldTimes() > 1 && U.nOldTimes() > 1)
    {
        shift(toMean.oldTime().oldTime(), U.oldTime().oldTime());
    }
    return fvc::ddtCorr(U, toMean);
}

}


Foam::faceMomentum::faceMomentum
(
    const fvVectorMatrix& UEqn,
    const stepCoefficients& step,
    const exchangeFields& grains,
    resolvedTerm& resolved,
    const volScalarField& rho,
    const surfaceScalarField& phiMomentum
)
:
    fluidA("fluidA", UEqn.A() - grains.beta),
    A("A", max(fluidA, leastA(step, rho))),
    beta(grains.beta),
    share
    (
        "share",
        shareOf(step, grains)/(A + (1 - step.eps)*rho/rho.time().deltaT())
    ),
    sharef("sharef", fvc::interpolate(share)),
    perForce
    (
        "perForce",
        1
       /(
            max(step.alpha, exchangeFields::epsMin)*step.share
          + grains.K*(A + grains.beta)
        )
    ),
    perShare
    (
        "perShare",
        1
       /(
            fvc::interpolate(share*perForce*A)
          + sharef*fvc::interpolate(perForce*beta)
        )
    ),
    inertiaFlux
    (
        "inertiaFlux",
        fvc::interpolate(share*perForce*step.alpha*step.eps*rho)
       *changeOfOldFlux(*this, step, resolved, UEqn.psi(), rho, phiMomentum)
    ),
    rAUf("rAUf", sharef*perShare),
    mobility("mobility", rAUf),
    diffusivity("diffusivity", rAUf),
    part(resolved.partOfSurface(grains))
{
    resolved.startCorrections
    (
        leastInertia(step, rho)/rho.time().deltaT(), A, step.betaf, rAUf
    );
    mobility = rAUf;
    if (part.valid())
    {
        mobility = part()*mobility;
    }
    resolved.addToMobility(mobility);
    diffusivity = mobility;
    if (grains.pressureDiffusion > 0)
    {
        diffusivity +=
            grains.pressureDiffusion*rho.time().deltaT()/fvc::interpolate(rho);
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMomentum::ofFaces
(
    const volScalarField& x
) const
{
    return
        fvc::interpolate(share*perForce*A*x)
      + sharef*fvc::interpolate(perForce*beta*x);
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMomentum::fluxOfFaces
(
    const volVectorField& x
) const
{
    return
        fvc::flux(share*perForce*A*x) + sharef*fvc::flux(perForce*beta*x);
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMomentum::fluidFlux
(
    const surfaceScalarField& flux,
    const surfaceScalarField& gradient,
    const volScalarField& alpha,
    const exchangeFields& grains
) const
{
    return
        (flux/perShare - fluxOfFaces(grains.G) + ofFaces(grains.K)*gradient)
       /ofFaces(alpha);
}


Foam::tmp<Foam::surfaceScalarField> Foam::faceMomentum::fluxWithoutPressure
(
    const volVectorField& HbyA,
    const volScalarField& alpha,
    const exchangeFields& grains
) const
{
    return
        perShare
       *(
            fvc::flux(share*perForce*A*(alpha*HbyA + grains.G))
          + sharef*fvc::flux(perForce*(alpha*grains.b + grains.beta*grains.G))
          + inertiaFlux
        );
}
