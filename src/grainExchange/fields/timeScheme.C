/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeScheme.H"

#include "dictionaryInput.H"
#include "fvMesh.H"
#include "surfaceFields.H"
#include "Time.H"

bool Foam::isSecondOrderInTime(const fvMesh& mesh)
{
    const word name("ddt(U)");
    const dictionary& schemes =
        dictionaryInput::subDict(mesh.schemesDict(), "ddtSchemes");

    return
        dictionaryInput::getWord
        (
            schemes, schemes.found(name) ? name : "default", {"Euler", "backward"}
        )
     == "backward";
}


Foam::weightsInTime::weightsInTime(const fvMesh& mesh, const bool hasEarlier)
{
    if (hasEarlier && isSecondOrderInTime(mesh))
    {
        const scalar deltaT = mesh.time().deltaTValue();
        const scalar both = deltaT + mesh.time().deltaT0Value();
        earlier = sqr(deltaT)/(mesh.time().deltaT0Value()*both);
        before = 1 + deltaT/both + earlier;
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::convectingFlux
(
    const surfaceScalarField& flux
)
{
    const surfaceScalarField& now = flux.oldTime();
    if (!isSecondOrderInTime(flux.mesh()))
    {
        return now;
    }
    const Time& time = flux.time();
    const scalar growth = time.deltaTValue()/time.deltaT0Value();
    return (1 + growth)*now - growth*now.oldTime();
}
