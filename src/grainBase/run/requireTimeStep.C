/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "requireTimeStep.H"

#include "dictionaryInput.H"
#include "Time.H"

void Foam::requireTimeStep(const Time& runTime)
{
    if (runTime.deltaTValue() <= 0)
    {
        dictionaryInput::badValue
        (
            runTime.controlDict(), "deltaT", name(runTime.deltaTValue()),
            "a value > 0"
        );
    }
}
