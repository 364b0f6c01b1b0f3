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
