/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedTerm.H"

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
