/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletReleases.H"

#include "dictionaryInput.H"

namespace
{

// In steps
constexpr Foam::scalar roundOff = 1e-6;

}


Foam::dropletReleases::dropletReleases
(
    const dictionary& properties,
    const grainSystem& droplets,
    const label firstId
)
:
    until_
    (
        IOobject
        (
            "releasedUntil",
            droplets.mesh().time().timeName(),
            "uniform",
            droplets.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    )
{
    if (!properties.found("releases"))
    {
        return;
    }
    const dictionary& dict = dictionaryInput::subDict(properties, "releases");
    const scalar until = before(droplets);

    label id = firstId;
    for (const word& name : dict.toc())
    {
        const dictionary& batch = dictionaryInput::subDict(dict, name);
        dictionaryInput::checkKeywords(batch, {"time", "droplets"});
        const scalar time = dictionaryInput::getScalar(batch, "time", dimTime, 0);
        const dictionary source(sourceOf(batch, "droplets"));
        releases_.append({time, source, id, time <= until});
        id += droplets.motion().countOf(source);
    }
}


Foam::dictionary Foam::dropletReleases::sourceOf
(
    const dictionary& properties,
    const word& keyword
)
{
    dictionary result(dictionaryInput::subDict(properties, keyword));
    if (result.found("temperature"))
    {
        dictionaryInput::badValue
        (
            result, "temperature", dictionaryInput::written(result, "temperature"),
            "none: droplets boil, or all begin with the temperature of 'saturation'"
        );
    }
    result.add("material", word("liquid"));
    return result;
}


Foam::scalar Foam::dropletReleases::before(const grainSystem& droplets) const
{
    if (until_.size())
    {
        return until_[0];
    }
    // Droplets that are fixed have no last step
    const scalar last = droplets.motion().lastTimeStep();
    return
        last > 0
      ? droplets.mesh().time().value() - last + roundOff*last
      : -GREAT;
}


bool Foam::dropletReleases::release
(
    grainSystem& droplets,
    const scalar now,
    const scalar deltaT
)
{
    until_.setSize(1);
    until_[0] = now + roundOff*deltaT;

    bool isAny = false;
    for (group& batch : releases_)
    {
        if (!batch.isDone && batch.time <= until_[0])
        {
            droplets.add(batch.source, batch.firstId);
            batch.isDone = true;
            isAny = true;
        }
    }
    return isAny;
}
