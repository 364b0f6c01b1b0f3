/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "functionKeywords.H"

#include "dictionaryInput.H"

void Foam::functionObjects::checkFunctionKeywords
(
    const dictionary& dict,
    const wordList& own
)
{
    // Those of OpenFOAM's timeControl and functionObjectList
    wordList allowed
    ({
        "type", "libs", "functionObjectLibs", "region", "enabled", "log",
        "timeStart", "timeEnd", "executeControl", "executeInterval",
        "writeControl", "writeInterval", "controlMode", "triggerStart",
        "triggerEnd", "nStepsToStartTimeChange", "deltaTCoeff", "errors",
        "useUserTime"
    });
    allowed.append(own);
    dictionaryInput::checkKeywords(dict, allowed);
}
