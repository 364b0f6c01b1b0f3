/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenStates.H"

#include "grainMotion.H"

namespace
{

using namespace Foam;

void begin(const std::vector<const grainMotion*>& motions)
{
    for (const grainMotion* motion : motions)
    {
        motion->beginWrite();
    }
}


//- The first, without which a time is incomplete, comes last
void end(const std::vector<const grainMotion*>& motions)
{
    for (auto motion = motions.rbegin(); motion != motions.rend(); ++motion)
    {
        (*motion)->endWrite();
    }
}

}


Foam::writtenStates::writtenStates
(
    Time& runTime,
    const std::vector<const grainMotion*>& motions
)
:
    time_(runTime),
    motions_(motions),
    written_(runTime.timeIndex())
{}


bool Foam::writtenStates::run()
{
    const bool goesOn = time_.run();
    if (time_.writeTime() && time_.timeIndex() != written_)
    {
        begin(motions_);
        end(motions_);
        written_ = time_.timeIndex();
    }
    return goesOn;
}


void Foam::writtenStates::write()
{
    begin(motions_);
    time_.writeNow();
    end(motions_);
    written_ = time_.timeIndex();
}
