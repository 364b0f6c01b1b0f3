/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyancy.H"

#include "meanOverGrains.H"

Foam::tmp<Foam::scalarField> Foam::buoyancy::seen() const
{
    const scalarField& rho = rho_.primitiveField();
    if (!grains_.voidFraction().smooths() || gMin(rho) == gMax(rho))
    {
        return rho;
    }
    tmp<scalarField> result(new scalarField(rho));
    grains_.voidFraction().smooth(result.ref());
    return result;
}


Foam::scalarField Foam::buoyancy::displaced() const
{
    const tmp<scalarField> rho(seen());
    return meanOverGrains(grains_, rho());
}
