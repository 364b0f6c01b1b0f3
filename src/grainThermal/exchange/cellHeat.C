/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellHeat.H"

#include "surfaceInterpolate.H"

Foam::cellHeat::cellHeat(const volScalarField& openConductivity)
:
    coefficient(openConductivity.size(), Zero),
    given(openConductivity.size(), Zero),
    conductivity
    (
        "conductivity", fvc::interpolate(openConductivity, "interpolate(kappa)")
    )
{}
