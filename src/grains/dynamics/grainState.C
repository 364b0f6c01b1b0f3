/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainState.H"

#include "OSspecific.H"
#include "Time.H"

Foam::fileName Foam::grainStateFile(const Time& runTime, const word& name)
{
    return runTime.globalPath()/runTime.timeName()/(name + ".h5");
}


bool Foam::continuesFromState(const Time& runTime, const word& name)
{
    const fileName file(grainStateFile(runTime, name));
    const bool found = isFile(file, false);

    if (!found && runTime.value() > 0)
    {
        FatalIOErrorInFunction(runTime.controlDict())
            << "Keyword 'startFrom': the start time " << runTime.timeName()
            << " has no state of the " << name << ", " << file << nl
            << "    allowed: a time whose directory has its " << name << ".h5 (that of"
            << " a decomposed case is beside the processor directories, not in"
            << " them: copy " << runTime.timeName() << '/' << name << ".h5, too)," << nl
            << "    or time 0 for the initial grains of"
            << " constant/grainProperties: rename the directory "
            << runTime.timeName() << " to 0 to put them into its fields"
            << exit(FatalIOError);
    }
    return found;
}
