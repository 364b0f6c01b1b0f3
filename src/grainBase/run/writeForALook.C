/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeForALook.H"

#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"

void Foam::writeForALook(const Time& runTime, const char* reason)
{
    const fileName dir(runTime.globalPath()/runTime.timeName());
    if (returnReduce(Pstream::master() && isFile(dir/"grains.h5"), orOp<bool>()))
    {
        return;
    }
    const_cast<Time&>(runTime).writeNow();
    if (Pstream::master())
    {
        mkDir(dir);
        OFstream(dir/"grains.h5.forALook")() << reason << endl;
    }
}
