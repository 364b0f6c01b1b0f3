/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ClausiusClapeyron.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace saturationCurves
{
    defineTypeNameAndDebug(ClausiusClapeyron, 0);
    addToRunTimeSelectionTable(saturationCurve, ClausiusClapeyron, dictionary);
}
}


Foam::saturationCurves::ClausiusClapeyron::ClausiusClapeyron
(
    const dictionary& dict
)
:
    p0_(dictionaryInput::getPositive(dict, "pressure", dimPressure)),
    T0_(dictionaryInput::getPositive(dict, "temperature", dimTemperature)),
    heatOverR_
    (
        dictionaryInput::getPositive(dict, "latentHeat", dimVelocity*dimVelocity)
       *dictionaryInput::getPositive(dict, "molarMass", dimensionSet(1, 0, 0, 0, -1))/8.31446
    )
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "pressure", "temperature", "latentHeat", "molarMass"}
    );
}
