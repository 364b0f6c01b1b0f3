/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "functionEntries.H"

#include "ITstream.H"

bool Foam::dictionaryInput::isFunction
(
    const dictionary& dict,
    const word& keyword
)
{
    if (!dict.found(keyword))
    {
        return false;
    }
    if (dict.isDict(keyword))
    {
        return true;
    }
    const ITstream& written = dict.lookup(keyword);
    return written.size() && written[0].isWord();
}


Foam::wordList Foam::dictionaryInput::functionKeywords
(
    const dictionary& dict,
    const wordList& keywords
)
{
    wordList all(keywords);
    for (const word& keyword : keywords)
    {
        // A name alone has its coefficients elsewhere
        if
        (
            isFunction(dict, keyword)
         && !dict.isDict(keyword)
         && dict.lookup(keyword).size() == 1
        )
        {
            all.append(keyword + "Coeffs");
        }
    }
    return all;
}
