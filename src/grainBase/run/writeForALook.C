/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeForALook.H"

#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"

bool Foam::writeForALook(const Time& runTime, const char* reason)
{
    const fileName dir(runTime.globalPath()/runTime.timeName());
    const bool isStart = runTime.timeIndex() == runTime.startTimeIndex();
    const bool isThere = Pstream::master() && isFile(dir/"grains.h5");
    if (isStart || returnReduce(isThere, orOp<bool>()))
    {
        return false;
    }
    const_cast<Time&>(runTime).writeNow();
    if (Pstream::master())
    {
        mkDir(dir);
        OFstream(dir/"grains.h5.forALook")() << reason << endl;
    }
    return true;
}
