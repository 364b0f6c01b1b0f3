/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatLaw.H"

#include "selected.H"
#include "shapeOfLaw.H"

namespace Foam
{
    defineTypeNameAndDebug(heatLaw, 0);
    defineRunTimeSelectionTable(heatLaw, dictionary);
}


Foam::autoPtr<Foam::heatLaw> Foam::heatLaw::New
(
    const dictionary& dict,
    const label nDimensions
)
{
    const auto construct =
        dictionaryInput::selected(*dictionaryConstructorTablePtr_, dict);

    autoPtr<heatLaw> law(construct(dict));

    const word shape
    (
        dictionaryInput::shapeOfLaw
        (
            dict,
            nDimensions == 3 ? "sphere" : "disc",
            wordList({law->shape()})
        )
    );
    law->surface_ = shape == "sphere" ? 6 : 4;
    return law;
}
