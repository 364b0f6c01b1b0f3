/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plateHeat.H"

#include "dictionaryInput.H"

Foam::plateHeat::plateHeat(const dictionary& transportProperties)
:
    coefficient_(0),
    temperature_(0)
{
    if (!transportProperties.found("HeleShaw"))
    {
        return;
    }
    const dictionary& plates =
        dictionaryInput::subDict(transportProperties, "HeleShaw");

    const dimensionSet dimHeatTransfer(1, 0, -3, -1, 0);
    coefficient_ =
        2
       *dictionaryInput::getScalarOrDefault
        (
            plates, "heatTransfer", dimHeatTransfer, 0, 0
        )
       /dictionaryInput::getPositive(plates, "gap", dimLength);
    if (coefficient_ > 0)
    {
        temperature_ =
            dictionaryInput::getPositive(plates, "temperature", dimTemperature);
    }
}
