/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enabledFunctions.H"

#include "Time.H"

std::vector<const Foam::dictionary*> Foam::enabledFunctions(const Time& runTime)
{
    std::vector<const dictionary*> result;
    const dictionary* functions = runTime.controlDict().findDict("functions");
    if (!functions || !runTime.functionObjects().status())
    {
        return result;
    }
    for (const entry& item : *functions)
    {
        if (item.isDict() && item.dict().getOrDefault("enabled", true))
        {
            result.push_back(&item.dict());
        }
    }
    return result;
}
