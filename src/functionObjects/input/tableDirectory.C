/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableDirectory.H"

#include "functionObject.H"
#include "OSspecific.H"
#include "Time.H"

Foam::fileName Foam::functionObjects::tableDirectory
(
    const Time& runTime,
    const word& name
)
{
    const fileName dir
    (
        runTime.globalPath()/"postProcessing"/name
       /(
            functionObject::postProcess
          ? word("postProcess")
          : Time::timeName(runTime.startTime().value())
        )
    );
    mkDir(dir);
    return dir;
}
