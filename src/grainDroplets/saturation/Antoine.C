/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Antoine.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace saturationCurves
{
    defineTypeNameAndDebug(Antoine, 0);
    addToRunTimeSelectionTable(saturationCurve, Antoine, dictionary);
}
}


Foam::saturationCurves::Antoine::Antoine(const dictionary& dict)
:
    A_(dictionaryInput::getScalar(dict, "A", dimless, -100, 100)),
    B_(dictionaryInput::getPositive(dict, "B", dimTemperature)),
    C_(dictionaryInput::getScalar(dict, "C", dimTemperature, -1000, 1000))
{
    dictionaryInput::checkKeywords(dict, {"type", "A", "B", "C"});
}
