/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lubricationLaw.H"

#include "dictionaryInput.H"
#include "selected.H"

namespace Foam
{
    defineTypeNameAndDebug(lubricationLaw, 0);
    defineRunTimeSelectionTable(lubricationLaw, dictionary);
}


Foam::autoPtr<Foam::lubricationLaw> Foam::lubricationLaw::New
(
    const dictionary& coupling
)
{
    if (!coupling.found("lubrication"))
    {
        return nullptr;
    }
    const dictionary& dict = dictionaryInput::subDict(coupling, "lubrication");
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict);
}
