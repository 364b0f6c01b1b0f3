/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "convectionByFraction.H"

#include "exchangeFields.H"
#include "fvc.H"

Foam::tmp<Foam::volVectorField> Foam::convectionByFraction
(
    const surfaceScalarField& massFlux,
    const volVectorField& U,
    const volScalarField& moves,
    const exchangeFields& grains
)
{
    const word scheme("div(" + massFlux.name() + ',' + U.name() + ')');
    const volScalarField div(fvc::div(massFlux));
    const auto convection = [&](const volVectorField& u)
    {
        return fvc::div(massFlux, u, scheme) - u*div;
    };
    const volVectorField ofMixture("ofMixture", moves*U);
    tmp<volVectorField> tresult
    (
        convection(U)
      - convection(ofMixture)/max(moves, exchangeFields::epsMin)
    );
    for (fvPatchVectorField& patch : tresult.ref().boundaryFieldRef())
    {
        if (!patch.coupled() && !grains.freePatches.found(patch.patch().index()))
        {
            patch == Zero;
        }
    }
    return tresult;
}
