/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "HeleShaw.H"

#include "dictionaryInput.H"

Foam::scalar Foam::HeleShawPlates
(
    const dictionary& dict,
    const wordList& moreEntries
)
{
    if (!dict.found("HeleShaw"))
    {
        return 0;
    }
    const dictionary& plates = dictionaryInput::subDict(dict, "HeleShaw");
    wordList allowed({"gap"});
    allowed.append(moreEntries);
    dictionaryInput::checkKeywords(plates, allowed);

    return 12/sqr(dictionaryInput::getPositive(plates, "gap", dimLength));
}
