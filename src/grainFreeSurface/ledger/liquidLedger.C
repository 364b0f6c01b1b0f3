/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquidLedger.H"

Foam::liquidLedger::liquidLedger
(
    const phaseFraction& phase,
    const surfaceTimeStep& limits,
    const Time& runTime
)
:
    phase_(phase),
    limits_(limits),
    time_(runTime),
    progress_(runTime),
    largest_(VSMALL),
    unaccounted_(0)
{}


void Foam::liquidLedger::endStep(const surfaceScalarField& phiU)
{
    largest_ = max(largest_, phase_.liquid());
    unaccounted_ += phase_.unaccounted();
    const scalar relative = unaccounted_/largest_;
    const scalar deltaT = time_.deltaTValue();
    const scalar surfaceCo = limits_.courantNumber(phiU)*deltaT;
    const scalar capillaryCo = deltaT/limits_.capillaryLimit();

    Info<< nl
        << "Liquid    " << phase_.liquid() << " m^3, unaccounted for "
        << relative << " of it, fraction " << phase_.range().first() << " to 1 "
        << (phase_.range().second() < 1 ? "- " : "+ ")
        << mag(phase_.range().second() - 1) << ", Courant number of the surface "
        << surfaceCo << ", capillary " << capillaryCo << endl;

    if (!Pstream::master())
    {
        return;
    }
    if (!file_)
    {
        file_ = progress_.newFile
        (
            "liquidLedger", "liquidLedger.csv",
            "time,liquid,broughtIn,unaccounted,leastAlpha,mostAlpha,surfaceCo,"
            "capillaryCo"
        );
    }
    const char c = ',';
    file_()
        << time_.value() << c << phase_.liquid() << c << phase_.broughtIn()
        << c << relative << c << phase_.range().first()
        << c << phase_.range().second() << c << surfaceCo
        << c << capillaryCo << endl;
}
