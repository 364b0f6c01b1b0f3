/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryInput.H"

#include "OStringStream.H"

Foam::string Foam::dictionaryInput::written
(
    const dictionary& dict,
    const word& keyword
)
{
    if (dict.isDict(keyword))
    {
        return "{ ... }";
    }
    OStringStream text;
    const char* separator = "";
    for (const token& t : static_cast<const tokenList&>(dict.lookup(keyword)))
    {
        text<< separator << t;
        separator = " ";
    }
    return text.str();
}


Foam::word Foam::dictionaryInput::getWord
(
    const dictionary& dict,
    const word& keyword,
    const wordList& allowed
)
{
    if (!dict.found(keyword))
    {
        missing(dict, keyword, listed(allowed));
    }
    const string value(written(dict, keyword));
    for (const word& name : allowed)
    {
        if (value == name || value == '"' + name + '"')
        {
            return name;
        }
    }
    badValue(dict, keyword, value, listed(allowed));
    return word::null;
}


Foam::word Foam::dictionaryInput::getWordOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const word& deflt,
    const wordList& allowed
)
{
    return dict.found(keyword) ? getWord(dict, keyword, allowed) : deflt;
}
