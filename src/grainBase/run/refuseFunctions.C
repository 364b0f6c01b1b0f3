/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refuseFunctions.H"

#include "dictionaryInput.H"
#include "enabledFunctions.H"

namespace
{

using namespace Foam;

//- What there is in the place of a function object; empty for all others
string inPlaceOf(const dictionary& function)
{
    const word type(function.getOrDefault<word>("type", ""));
    if (type == "setTimeStep")
    {
        return
            "function objects that leave steps to the solver, which has"
            " maxDeltaT of controlDict and its other limits";
    }
    if (type == "wallHeatFlux" || type == "heatTransferCoeff")
    {
        return
            "function objects that know heat without a thermophysical model;"
            " what passes each patch is in postProcessing/heatLedger";
    }
    if
    (
        type == "cloudInfo"
     && function.getOrDefault("clouds", wordList()).found("grains")
    )
    {
        return
            "clouds of OpenFOAM's parcels; of grains there are"
            " postProcessing/ledger, grainTracks and grainProfiles";
    }
    return string();
}

}


void Foam::refuseFunctions(const Time& runTime)
{
    for (const dictionary* dict : enabledFunctions(runTime))
    {
        const string allowed(inPlaceOf(*dict));
        if (allowed.size())
        {
            dictionaryInput::badValue
            (
                *dict, "type", dict->get<word>("type"), allowed
            );
        }
    }
}
