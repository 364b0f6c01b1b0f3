/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedTerm.H"

#include "cutGrains.H"
#include "lockedGrains.H"
#include "noResolvedTerm.H"

Foam::chosenOption Foam::resolvedTerm::chosen
(
    const dictionary& coupling,
    const bool isPossible
)
{
    return couplingOption
    (
        coupling, "resolvedGrains", wordList({"locked", "cutCells"}),
        {"from", 4, 2, 100}, isPossible
    );
}


Foam::autoPtr<Foam::resolvedTerm> Foam::resolvedTerm::New
(
    const grainSystem& grains,
    const carrier& fluid
)
{
    const chosenOption option
    (
        chosen(grains.motion().coupling(), grains.voidFraction().resolves())
    );
    if (!option.number)
    {
        return autoPtr<resolvedTerm>(new noResolvedTerm(grains.mesh()));
    }
    return
        option.type == "cutCells"
      ? autoPtr<resolvedTerm>(new cutGrains(grains, fluid, *option.number))
      : autoPtr<resolvedTerm>(new lockedGrains(grains, fluid, *option.number));
}


void Foam::resolvedTerm::predict
(
    fvVectorMatrix& UEqn,
    const volVectorField& pressureForce
) const
{
    solve(UEqn == -pressureForce);
}


Foam::tmp<Foam::surfaceScalarField> Foam::resolvedTerm::onFaces
(
    const tmp<surfaceScalarField>& others,
    const tmp<surfaceScalarField>& locked
) const
{
    if (!isActive())
    {
        locked.clear();
        return others;
    }
    return (1 - lockedFaces())*others + lockedFaces()*locked;
}
