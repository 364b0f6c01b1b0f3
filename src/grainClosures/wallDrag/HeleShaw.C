/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "HeleShaw.H"

#include "dictionaryInput.H"

Foam::scalar Foam::HeleShawPlates(const dictionary& dict)
{
    if (!dict.found("HeleShaw"))
    {
        return 0;
    }
    const dictionary& plates = dictionaryInput::subDict(dict, "HeleShaw");
    dictionaryInput::checkKeywords(plates, {"gap"});

    return 12/sqr(dictionaryInput::getPositive(plates, "gap", dimLength));
}
