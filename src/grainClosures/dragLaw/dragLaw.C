/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"

#include "selected.H"
#include "shapeOfLaw.H"

namespace Foam
{
    defineTypeNameAndDebug(dragLaw, 0);
    defineRunTimeSelectionTable(dragLaw, dictionary);
}


Foam::autoPtr<Foam::dragLaw> Foam::dragLaw::New
(
    const dictionary& dict,
    const label nDimensions
)
{
    const auto construct =
        dictionaryInput::selected(*dictionaryConstructorTablePtr_, dict);

    dictionary full(dict);
    if (!full.found("shape"))
    {
        full.add("shape", word(nDimensions == 3 ? "sphere" : "disc"));
    }
    autoPtr<dragLaw> law(construct(full));

    dictionaryInput::shapeOfLaw
    (
        dict, nDimensions == 3 ? "sphere" : "disc", law->shapes()
    );
    return law;
}
