/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writingTimes.H"

#include "dictionaryInput.H"
#include "dimensionSets.H"
#include "IOdictionary.H"

Foam::writingTimes::writingTimes(Time& runTime)
:
    time_(runTime),
    start_(runTime.value())
{
    const IOdictionary last
    (
        IOobject
        (
            "time",
            runTime.timeName(),
            "uniform",
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    const scalar value = last.getOrDefault<scalar>("value", start_);
    if
    (
        interval(runTime) < GREAT
     && Time::timeName(value) == runTime.timeName()
    )
    {
        start_ = value;
        runTime.setTime(value, runTime.timeIndex());
    }
}


Foam::scalar Foam::writingTimes::interval(const Time& runTime)
{
    const word control
    (
        runTime.controlDict().getOrDefault<word>("writeControl", "timeStep")
    );
    if (control != "adjustable" && control != "adjustableRunTime")
    {
        return GREAT;
    }
    const scalar interval = dictionaryInput::getPositive
    (
        runTime.controlDict(), "writeInterval", dimTime
    );
    return onGrid(interval, interval);
}


Foam::scalar Foam::writingTimes::toNext(const scalar deltaT) const
{
    const scalar length = interval(time_);
    if (length >= GREAT)
    {
        return GREAT;
    }

    // A start between two times of writing shifts them all
    const scalar origin = onGrid(std::remainder(start_, length), length);
    const scalar elapsed = time_.value() - origin;
    return length*(std::floor((elapsed + 1e-6*deltaT)/length) + 1) - elapsed;
}


Foam::scalar Foam::writingTimes::step(const scalar deltaT) const
{
    const scalar length = interval(time_);
    if (length >= GREAT)
    {
        return deltaT;
    }
    const scalar step = dividing(toNext(deltaT), deltaT);

    // A short step of a long interval keeps half of the digits
    const scalar digits = min(length, std::ldexp(step, bits/2));
    return onGrid(time_.value() + step, digits) - time_.value();
}


Foam::scalar Foam::writingTimes::dividing
(
    const scalar time,
    const scalar deltaT
)
{
    // What is left of a step by round-off is none
    return time/max(std::ceil(time/deltaT*(1 - 1e-9)), 1.0);
}


Foam::scalar Foam::writingTimes::onGrid
(
    const scalar time,
    const scalar length
)
{
    const scalar spacing = std::ldexp(1.0, std::ilogb(length) - bits);
    return spacing*std::nearbyint(time/spacing);
}
