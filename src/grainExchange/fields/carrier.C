/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carrier.H"

#include "surfaceInterpolate.H"

Foam::tmp<Foam::volScalarField> Foam::carrier::inertia
(
    const volScalarField& share
) const
{
    return share*rho();
}


Foam::tmp<Foam::surfaceScalarField> Foam::carrier::massFlux
(
    const volScalarField&,
    const surfaceScalarField& phiEps
) const
{
    return tmp<surfaceScalarField>
    (
        new surfaceScalarField(phiEps.name(), fvc::interpolate(rho())*phiEps)
    );
}
