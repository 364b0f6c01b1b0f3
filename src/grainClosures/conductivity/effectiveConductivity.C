/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectiveConductivity.H"

#include "dictionaryInput.H"
#include "selected.H"
#include "shapeOfLaw.H"

namespace Foam
{
    defineTypeNameAndDebug(effectiveConductivity, 0);
    defineRunTimeSelectionTable(effectiveConductivity, dictionary);
}


Foam::autoPtr<Foam::effectiveConductivity> Foam::effectiveConductivity::New
(
    const dictionary& coupling,
    const label nDimensions,
    const word& keyword
)
{
    dictionary deflt;
    deflt.add("type", "none");

    const dictionary& dict =
        coupling.found(keyword)
      ? dictionaryInput::subDict(coupling, keyword)
      : deflt;

    autoPtr<effectiveConductivity> law
    (
        dictionaryInput::selected(*dictionaryConstructorTablePtr_, dict)(dict)
    );
    const word shape
    (
        dictionaryInput::shapeOfLaw
        (
            dict, nDimensions == 3 ? "sphere" : "disc", law->shapes()
        )
    );
    law->nDimensions_ = shape == "sphere" ? 3 : 2;
    return law;
}
