/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchesOfGivenVelocity.H"

#include "wallFvPatch.H"

Foam::patchesOfGivenVelocity::patchesOfGivenVelocity
(
    const string& bodies,
    const bool areFixed
)
:
    bodies_(bodies),
    areFixed_(areFixed)
{}


bool Foam::patchesOfGivenVelocity::isGiven(const fvPatchVectorField& U)
{
    return
        U.fixesValue() && !U.assignable()
     && !U.coupled() && !isA<wallFvPatch>(U.patch());
}


bool Foam::patchesOfGivenVelocity::areFilled
(
    const fvPatchScalarField& fluidShare
) const
{
    // With less left the force on a fixed disc in cut cells is above twenty times
    // that in the flow
    constexpr scalar least = 0.1;

    const scalarField share(fluidShare.patchInternalField());
    bool isAny = false;
    for (const scalar x : share)
    {
        isAny = isAny || x < least;
    }
    return returnReduce(isAny, orOp<bool>());
}


void Foam::patchesOfGivenVelocity::tell(const fvPatch& patch) const
{
    Info<< bodies_.c_str() << " fill cells at patch " << patch.name()
        << ", which gives the velocity, in the step to time "
        << patch.boundaryMesh().mesh().time().timeName() << ": ";
    if (areFixed_)
    {
        Info<< "the force on them is not that of a flow, but what holds the fluid"
            << " of the patch";
    }
    else
    {
        Info<< "while they are there they move with the fluid of the patch, and"
            << " their own velocity, such as that of the entry 'velocity', is lost";
    }
    Info<< " (said once)" << endl;
}


void Foam::patchesOfGivenVelocity::look
(
    const volVectorField& U,
    const volScalarField& fluidShare
)
{
    forAll(U.boundaryField(), patchi)
    {
        if
        (
            !told_.found(patchi) && isGiven(U.boundaryField()[patchi])
         && areFilled(fluidShare.boundaryField()[patchi])
        )
        {
            told_.insert(patchi);
            tell(U.boundaryField()[patchi].patch());
        }
    }
}
