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
    phiGrains("phiGrains", fvc::flux(grains.G))
{
    resolved.startCorrections
    (
        leastInertia(step, rho)/rho.time().deltaT(), A, step.betaf, rAUf
    );
    mobility = rAUf + fvc::interpolate(grains.K);
    diffusivity = mobility;
    if (grains.pressureDiffusion > 0)
    {
        diffusivity +=
            grains.pressureDiffusion*rho.time().deltaT()/fvc::interpolate(rho);
    }
}
