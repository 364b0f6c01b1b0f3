/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "anglesAtWalls.H"

#include "alphaContactAngleTwoPhaseFvPatchScalarField.H"
#include "missingFields.H"

namespace
{

using namespace Foam;

using angle = alphaContactAngleTwoPhaseFvPatchScalarField;


bool hasAngles(const volScalarField& alpha)
{
    for (const fvPatchScalarField& patch : alpha.boundaryField())
    {
        if (isA<angle>(patch))
        {
            return true;
        }
    }
    return false;
}


IOobject stateField(const fvMesh& mesh, const char* name, const bool isWritten)
{
    return IOobject
    (
        name, mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT,
        isWritten ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
    );
}

}


Foam::anglesAtWalls::anglesAtWalls(const volScalarField& alpha)
:
    isAny_(hasAngles(alpha)),
    isKnown_
    (
        isAny_
     && isThere(alpha.mesh(), "alphaAtWalls")
     && isThere(alpha.mesh(), "alphaGradientAtWalls")
    ),
    value_
    (
        stateField(alpha.mesh(), "alphaAtWalls", isAny_),
        alpha.mesh(),
        dimensionedScalar(dimless, Zero)
    ),
    gradient_
    (
        stateField(alpha.mesh(), "alphaGradientAtWalls", isAny_),
        alpha.mesh(),
        dimensionedScalar(dimless/dimLength, Zero)
    )
{}


void Foam::anglesAtWalls::keep(const volScalarField& alpha)
{
    forAll(alpha.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha.boundaryField()[patchi];
        if (isA<angle>(patch))
        {
            value_.boundaryFieldRef()[patchi] == patch;
            gradient_.boundaryFieldRef()[patchi] ==
                refCast<const angle>(patch).gradient();
        }
    }
}


void Foam::anglesAtWalls::restore(volScalarField& alpha) const
{
    if (!isKnown_)
    {
        return;
    }
    forAll(alpha.boundaryField(), patchi)
    {
        fvPatchScalarField& patch = alpha.boundaryFieldRef()[patchi];
        if (isA<angle>(patch))
        {
            refCast<angle>(patch).gradient() = gradient_.boundaryField()[patchi];
            patch == value_.boundaryField()[patchi];
        }
    }
}
