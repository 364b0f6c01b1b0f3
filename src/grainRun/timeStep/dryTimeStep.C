/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dryTimeStep.H"

#include "adjustableTimeStep.H"
#include "refuseFunctions.H"
#include "requireTimeStep.H"

Foam::dryTimeStep::dryTimeStep
(
    Time& runTime,
    const grainMotion& grains,
    const vector& g
)
:
    time_(runTime),
    times_(runTime),
    grains_(grains),
    acceleration_(mag(g))
{
    requireTimeStep(runTime);
    refuseFunctions(runTime);
    adjustableTimeStep::limits checked(runTime.controlDict());
}


void Foam::dryTimeStep::set()
{
    const adjustableTimeStep::limits given(time_.controlDict());
    if (!given.adjusts)
    {
        return;
    }
    adjustableTimeStep::take
    (
        time_,
        times_,
        grains_.lastTimeStep(),
        {
            {
                "maxGrainDisplacement",
                adjustableTimeStep::displacementLimit
                (
                    grains_, given.maxGrainDisplacement,
                    [&](const label) { return acceleration_; }
                )
            },
            {"frequency", grains_.maxDeltaTOfWalls()},
            {"maxDeltaT", given.maxDeltaT}
        },
        given.minDeltaT
    );
}
