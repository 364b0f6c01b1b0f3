/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inertialForce.H"

#include "faceMomentum.H"
#include "fvc.H"
#include "reconstruction.H"

namespace
{

//- Of a cell's inertia in that of a face
Foam::tmp<Foam::volScalarField> movingShare
(
    const Foam::stepCoefficients& step,
    const Foam::exchangeFields& grains
)
{
    return max(Foam::faceMomentum::moving(step, grains), Foam::scalar(Foam::SMALL));
}

}


Foam::inertialForce::inertialForce
(
    const stepCoefficients& step,
    const exchangeFields& grains,
    const volScalarField& rho
)
:
    step_(step),
    grains_(grains),
    whole_("whole", rho/rho.time().deltaT()),
    wholef_("wholef", 1/fvc::interpolate(1/whole_)),
    inertia_
    (
        "inertia",
        1
       /(
            max(step.alpha, exchangeFields::epsMin)*step.share/step.eps
          + whole_*grains.K*step.still
        )
    ),
    weight_
    (
        "weight",
        movingShare(step, grains)*step.still*inertia_
    ),
    sum_
    (
        "sum",
        fvc::interpolate(movingShare(step, grains))*fvc::interpolate(step.still)
    )
{}


Foam::tmp<Foam::volVectorField> Foam::inertialForce::besidesInertia
(
    const surfaceScalarField& ofFaces,
    const surfaceScalarField& force,
    const volVectorField& gained
) const
{
    surfaceScalarField rest
    (
        "rest",
        ofFaces
      + (fvc::interpolate(weight_)*force - fvc::flux(weight_*whole_*gained))/sum_
    );
    forAll(rest.boundaryField(), patchi)
    {
        fvsPatchScalarField& patch = rest.boundaryFieldRef()[patchi];
        if (!patch.coupled() && !grains_.freePatches.found(patchi))
        {
            patch == 0;
        }
    }
    return reconstructed(rest);
}


Foam::tmp<Foam::volVectorField> Foam::inertialForce::gradient
(
    const surfaceScalarField& ofFaces,
    const surfaceScalarField& flux,
    const surfaceScalarField& oldFlux
) const
{
    // What grains gain has the gradient that is looked for
    constexpr label sweeps = 3;

    const volScalarField& still = step_.still;
    const volVectorField drag
    (
        "drag", step_.bByShare - step_.betaByShare*reconstructed(flux)
    );
    const surfaceScalarField other
    (
        "other",
        (ofFaces - step_.phib + step_.betaf*flux)/fvc::interpolate(still)
    );
    const surfaceScalarField force("force", wholef_*(flux - oldFlux));
    const volVectorField accelerated(reconstructed(force));

    volVectorField rest("rest", reconstructed(other));
    volVectorField gained("gained", grains_.gained);
    for (label sweep = 0; sweep < sweeps; ++sweep)
    {
        gained = grains_.gained - grains_.K*(still*rest + drag);
        rest = besidesInertia(other, force, gained);
    }
    return
        still*(rest - inertia_*(accelerated - whole_*gained)) + drag;
}
