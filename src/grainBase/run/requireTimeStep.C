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

    const dictionary* functions = runTime.controlDict().findDict("functions");
    if (!functions || !runTime.functionObjects().status())
    {
        return;
    }
    for (const entry& item : *functions)
    {
        if
        (
            item.isDict()
         && item.dict().getOrDefault("enabled", true)
         && item.dict().getOrDefault<word>("type", "") == "setTimeStep"
        )
        {
            dictionaryInput::badValue
            (
                item.dict(), "type", "setTimeStep",
                "function objects that leave steps to the solver, which has"
                " maxDeltaT of controlDict and its other limits"
            );
        }
    }
}
