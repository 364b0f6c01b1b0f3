/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writingTimes.H"

#include "dictionaryInput.H"
#include "dimensionSets.H"
#include "enabledFunctions.H"
#include "IOdictionary.H"

#include <algorithm>

namespace
{

using namespace Foam;

bool isMet(const dictionary& dict)
{
    const word control(dict.getOrDefault<word>("writeControl", "timeStep"));
    return control == "adjustable" || control == "adjustableRunTime";
}

}


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
        gridLength(runTime) < GREAT
     && Time::timeName(value) == runTime.timeName()
    )
    {
        start_ = value;
        runTime.setTime(value, runTime.timeIndex());
    }
}


Foam::scalar Foam::writingTimes::interval(const Time& runTime)
{
    if (!isMet(runTime.controlDict()))
    {
        return GREAT;
    }
    const scalar interval = dictionaryInput::getPositive
    (
        runTime.controlDict(), "writeInterval", dimTime
    );
    return onGrid(interval, interval);
}


std::vector<Foam::scalar> Foam::writingTimes::intervalsOfFunctions
(
    const Time& runTime
)
{
    std::vector<scalar> intervals;
    for (const dictionary* dict : enabledFunctions(runTime))
    {
        const scalar length =
            isMet(*dict) ? dict->getOrDefault<scalar>("writeInterval", 0) : 0;
        if (length > 0)
        {
            intervals.push_back(length);
        }
    }
    return intervals;
}


Foam::scalar Foam::writingTimes::gridLength(const Time& runTime)
{
    const scalar ofFields = interval(runTime);
    const std::vector<scalar> others(intervalsOfFunctions(runTime));
    return
        ofFields < GREAT || others.empty()
      ? ofFields
      : *std::min_element(others.begin(), others.end());
}


Foam::scalar Foam::writingTimes::toMultiple
(
    const scalar length,
    const scalar gridLength,
    const scalar margin
) const
{
    // A start between two times of writing shifts them all; multiples of another
    // length are on the grid to round-off
    const scalar shift = std::remainder(start_, length);
    const scalar origin =
        mag(shift) > 1e-9*length ? onGrid(shift, gridLength) : 0;
    const scalar elapsed = time_.value() - origin;
    return length*(std::floor((elapsed + margin)/length) + 1) - elapsed;
}


Foam::scalar Foam::writingTimes::toNext(const scalar deltaT) const
{
    const scalar length = interval(time_);
    const scalar toFields =
        length < GREAT ? toMultiple(length, length, 1e-6*deltaT) : GREAT;

    scalar next = toFields;
    const scalar grid = gridLength(time_);
    for (const scalar other : intervalsOfFunctions(time_))
    {
        const scalar toOther = toMultiple(other, grid, 0.5*deltaT);
        if (toOther < min(next, toFields - 0.5*deltaT))
        {
            next = toOther;
        }
    }
    return next;
}


Foam::scalar Foam::writingTimes::step(const scalar deltaT) const
{
    const scalar length = gridLength(time_);
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
