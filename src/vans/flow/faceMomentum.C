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


//- Flux of a face less that of its cells, at the beginning of the step, per time
tmp<surfaceScalarField> changeOfOldFlux
(
    const volScalarField& A,
    const stepCoefficients& step,
    const resolvedTerm& resolved,
    const volVectorField& U,
    const volScalarField& rho,
    const surfaceScalarField& phiU
)
{
    const dimensionedScalar& deltaT = rho.time().deltaT();
    if (resolved.isActive())
    {
        // Drag and viscosity bring the flux of a face to that of its cells.  With
        // OpenFOAM's limiter in their place the drag of narrow gaps depends on
        // the time step (doc/theory, eq. 3.14).
        return
            fvc::interpolate(leastInertia(step, rho)/(A*deltaT))
           *(phiU.oldTime() - fvc::flux(U.oldTime()))/deltaT;
    }
    return fvc::ddtCorr(U, phiU);
}

}


Foam::faceMomentum::faceMomentum
(
    const fvVectorMatrix& UEqn,
    const stepCoefficients& step,
    const exchangeFields& grains,
    resolvedTerm& resolved,
    const volScalarField& rho,
    const surfaceScalarField& phiU
)
:
    fluidA("fluidA", UEqn.A() - grains.beta),
    A("A", max(fluidA, leastA(step, rho))),
    rAf("rAf", fvc::interpolate(step.eps*step.alpha*step.share/A)),
    drag("drag", fvc::interpolate(step.eps) + rAf*step.betaf),
    inertiaFlux
    (
        "inertiaFlux",
        fvc::interpolate(rho*sqr(step.eps)*step.alpha/A)
       *changeOfOldFlux(A, step, resolved, UEqn.psi(), rho, phiU)
    ),
    rAUf("rAUf", rAf/drag),
    mobility("mobility", rAUf),
    diffusivity("diffusivity", rAUf),
    part(resolved.partOfSurface(grains)),
    phiGrains
    (
        "phiGrains", (1 - resolved.lockedFaces())*fvc::flux(grains.G)
    )
{
    resolved.startCorrections
    (
        leastInertia(step, rho)/rho.time().deltaT(), A, step.betaf, rAUf
    );
    if (resolved.isPassable())
    {
        // One cell after the other, each with its own mobility: fluid and grains
        const volScalarField laden(pos(1 - step.eps - resolved.locked() - SMALL));
        mixed = (1 - resolved.lockedFaces())*pos(fvc::interpolate(laden) - SMALL);
        cellMobility = step.alpha*step.share/(A + grains.beta) + grains.K;
        rAUf =
            (1 - mixed())*rAUf
          + mixed()/fvc::interpolate(1/cellMobility());
        phiGrains *= 1 - mixed();
    }

    // Beside a body the flux is that of the mixture
    mobility = rAUf + (1 - resolved.lockedFaces())*fvc::interpolate(grains.K);
    if (mixed.valid())
    {
        mobility = (1 - mixed())*mobility + mixed()*rAUf;
    }
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


void Foam::faceMomentum::mix
(
    const volVectorField& momentum,
    const stepCoefficients& step,
    const exchangeFields& grains,
    surfaceScalarField& flux
) const
{
    if (!mixed.valid())
    {
        return;
    }
    const volScalarField perForce
    (
        step.alpha/(A + grains.beta)/cellMobility()
    );
    const surfaceScalarField changeOfOld
    (
        inertiaFlux/fvc::interpolate(step.inertia*step.eps*step.alpha/A)
    );
    flux =
        (1 - mixed())*flux
      + mixed()*rAUf
       *(
            fvc::flux(perForce*(momentum + grains.b) + grains.G/cellMobility())
          + fvc::interpolate(perForce*step.inertia)*changeOfOld
        );
}
