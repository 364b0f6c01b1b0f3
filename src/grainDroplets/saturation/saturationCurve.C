/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "saturationCurve.H"

#include "selected.H"

namespace Foam
{
    defineTypeNameAndDebug(saturationCurve, 0);
    defineRunTimeSelectionTable(saturationCurve, dictionary);
}


Foam::autoPtr<Foam::saturationCurve> Foam::saturationCurve::New
(
    const dictionary& dict
)
{
    return dictionaryInput::selected(*dictionaryConstructorTablePtr_, dict)(dict);
}
