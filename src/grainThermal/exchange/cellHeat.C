/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellHeat.H"

#include "harmonic.H"
#include "surfaceInterpolate.H"

Foam::cellHeat::cellHeat
(
    const volScalarField& openConductivity,
    const bool inSeries
)
:
    coefficient(openConductivity.size(), Zero),
    given(openConductivity.size(), Zero),
    conductivity
    (
        "conductivity",
        inSeries
      ? harmonic(openConductivity.mesh()).interpolate(openConductivity)
      : fvc::interpolate(openConductivity, "interpolate(kappa)")
    )
{}
