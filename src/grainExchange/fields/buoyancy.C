/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyancy.H"

#include "meanOverGrains.H"

Foam::scalarField Foam::buoyancy::displaced() const
{
    return meanOverGrains(grains_, rho_);
}
