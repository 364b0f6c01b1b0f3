/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatLaw.H"

#include "mathematicalConstants.H"
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
    using constant::mathematical::pi;
    const bool isOfSpheres = shape == "sphere";
    law->surface_ = isOfSpheres ? 6 : 4;
    law->leastEps_ = 1 - pi/std::sqrt(isOfSpheres ? 18.0 : 12.0);
    return law;
}
