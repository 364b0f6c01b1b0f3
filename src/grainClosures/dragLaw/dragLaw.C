/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"

#include "selected.H"

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
    autoPtr<dragLaw> law
    (
        dictionaryInput::selected(*dictionaryConstructorTablePtr_, dict)(dict)
    );
    if (law->isOfDiscs() && nDimensions == 3)
    {
        dictionaryInput::badValue
        (
            dict, "shape", "disc",
            "sphere, as this mesh is three-dimensional"
        );
    }
    return law;
}
