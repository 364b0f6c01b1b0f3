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
{
    if (!properties.found("releases"))
    {
        return;
    }
    const dictionary& dict = dictionaryInput::subDict(properties, "releases");
    const scalar last = droplets.motion().lastTimeStep();
    const scalar before =
        last > 0
      ? droplets.mesh().time().value() - last + roundOff*last
      : -GREAT;

    label id = firstId;
    for (const word& name : dict.toc())
    {
        const dictionary& batch = dictionaryInput::subDict(dict, name);
        dictionaryInput::checkKeywords(batch, {"time", "droplets"});
        const scalar time = dictionaryInput::getScalar(batch, "time", dimTime, 0);
        dictionary source(dictionaryInput::subDict(batch, "droplets"));
        source.add("material", word("liquid"));
        releases_.append({time, source, id, time <= before});
        id += droplets.motion().countOf(source);
    }
}


bool Foam::dropletReleases::release
(
    grainSystem& droplets,
    const scalar now,
    const scalar deltaT
)
{
    bool isAny = false;
    for (group& batch : releases_)
    {
        if (!batch.isDone && batch.time <= now + roundOff*deltaT)
        {
            droplets.add(batch.source, batch.firstId);
            batch.isDone = true;
            isAny = true;
        }
    }
    return isAny;
}
