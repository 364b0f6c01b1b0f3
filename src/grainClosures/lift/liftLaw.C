/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liftLaw.H"

#include "dictionaryInput.H"
#include "selected.H"
#include "shapeOfLaw.H"

namespace Foam
{
    defineTypeNameAndDebug(liftLaw, 0);
    defineRunTimeSelectionTable(liftLaw, dictionary);
}


Foam::autoPtr<Foam::liftLaw> Foam::liftLaw::New(const dictionary& dict)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict);
}


Foam::PtrList<Foam::liftLaw> Foam::liftLaw::all(const dictionary& coupling)
{
    PtrList<liftLaw> laws;
    if (coupling.found("lift"))
    {
        const dictionary& dict = dictionaryInput::subDict(coupling, "lift");
        const word ofGrains
        (
            coupling.topDict().getOrDefault<word>("shape", "sphere")
        );
        for (const word& name : dict.toc())
        {
            const dictionary& law = dictionaryInput::subDict(dict, name);
            laws.append(New(law));
            dictionaryInput::shapeOfLaw(law, ofGrains, {"sphere"});
        }
    }
    return laws;
}
