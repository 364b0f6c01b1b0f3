/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceMomentum.H"

#include "cyclicAMIFvPatch.H"
#include "fvc.H"
#include "timeScheme.H"

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


//- OpenFOAM's limiter of what a flux differs from that of its cells by, which
//  knows no size of the case
tmp<surfaceScalarField> limiter
(
    const surfaceScalarField& flux,
    const surfaceScalarField& difference
)
{
    tmp<surfaceScalarField> tresult
    (
        1
      - min
        (
            mag(difference)
           /(mag(flux) + dimensionedScalar("small", flux.dimensions(), VSMALL)),
            scalar(1)
        )
    );
    tresult.ref().setOriented(false);
    return tresult;
}


//- The same between cells of two fluids; 1 between others
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
    return 1 - pos(jump - 1e-3)*(1 - limiter(flux, difference));
}


//- A limiter as it is, but 0 at boundaries that give the velocity
tmp<surfaceScalarField> inside
(
    const surfaceScalarField& limiter,
    const volVectorField& U
)
{
    tmp<surfaceScalarField> tresult(new surfaceScalarField(limiter));
    surfaceScalarField::Boundary& boundary = tresult.ref().boundaryFieldRef();
    forAll(boundary, patchi)
    {
        if
        (
            U.boundaryField()[patchi].fixesValue()
         || isA<cyclicAMIFvPatch>(U.mesh().boundary()[patchi])
        )
        {
            boundary[patchi] = 0;
        }
    }
    return tresult;
}


//- A flux as the faces see it: among grains no limiter must know how fast all moves
//  together.  Without grains it is OpenFOAM's.
tmp<surfaceScalarField> pastFaces
(
    const surfaceScalarField& flux,
    const stepCoefficients& step
)
{
    return
        flux.mesh().moving() && gMin(step.eps.primitiveField()) < 1
      ? flux - flux.mesh().phi()
      : tmp<surfaceScalarField>(flux);
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
    const auto beyondCells =
        [&](const surfaceScalarField& flux, const volVectorField& u)
        {
            return flux - faces.fluxOfFaces(step.alpha*u)/ofBoth;
        };
    const surfaceScalarField& flux = phi.oldTime();
    const surfaceScalarField difference(beyondCells(flux, U.oldTime()));
    if (resolved.isActive())
    {
        // Drag and viscosity bring the flux of a face to that of its cells.  With
        // OpenFOAM's limiter in their place the drag of narrow gaps depends on
        // the time step (doc/theory, eq. 3.14).
        return
            inside
            (
                limiterBetweenFluids(pastFaces(flux, step)(), difference, rho)(), U
            )
           *fvc::interpolate(leastInertia(step, rho)/(faces.A*deltaT))
           *difference/deltaT;
    }

    const bool hasEarlier = phi.nOldTimes() > 1 && U.nOldTimes() > 1;
    const weightsInTime weights(rho.mesh(), hasEarlier);
    surfaceScalarField change(weights.before*difference);
    if (hasEarlier && weights.earlier > 0)
    {
        change -= weights.earlier
           *beyondCells(flux.oldTime(), U.oldTime().oldTime());
    }
    const surfaceScalarField ofFace(fvc::flux(U.oldTime()) + difference);
    return
        inside(limiter(pastFaces(ofFace, step)(), difference)(), U)
       *change/deltaT;
}

}


Foam::tmp<Foam::volScalarField> Foam::faceMomentum::moving
(
    const stepCoefficients& step,
    const exchangeFields& grains
)
{
    tmp<volScalarField> moves(step.alpha + grains.mobile);
    return grains.gradientOnGrains ? sqr(moves) : moves;
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
    fluidA("fluidA", UEqn.A() - step.beta),
    A("A", max(fluidA, leastA(step, rho))),
    beta(step.beta),
    share
    (
        "share",
        moving(step, grains)/(A + (1 - step.eps)*rho/rho.time().deltaT())
    ),
    sharef("sharef", fvc::interpolate(share)),
    perForce
    (
        "perForce",
        1
       /(
            max(step.alpha, exchangeFields::epsMin)*step.share
          + grains.K*(A + beta)
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
    const stepCoefficients& step,
    const exchangeFields& grains
) const
{
    return
        perShare
       *(
            fvc::flux(share*perForce*A*(step.alpha*HbyA + grains.G))
          + sharef*fvc::flux(perForce*(step.alpha*step.b + beta*grains.G))
          + inertiaFlux
        );
}
