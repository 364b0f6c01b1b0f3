/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingOption.H"

#include "coarseGraining.H"

std::optional<Foam::scalar> Foam::couplingOption
(
    const dictionary& coupling,
    const word& keyword,
    const word& type,
    const optionNumber& number,
    const bool isPossible
)
{
    return couplingOption
    (
        coupling, keyword, wordList(1, type), number, isPossible
    ).number;
}


Foam::chosenOption Foam::couplingOption
(
    const dictionary& coupling,
    const word& keyword,
    const wordList& types,
    const optionNumber& number,
    const bool isPossible
)
{
    const bool isCoarse = coarseGraining(coupling) > 1;
    word type(types[0]);
    std::optional<scalar> value(number.deflt);
    if (coupling.found(keyword))
    {
        const dictionary& dict = dictionaryInput::subDict(coupling, keyword);
        dictionaryInput::checkKeywords(dict, {"type", number.keyword});
        value = dictionaryInput::getScalarOrDefault
        (
            dict, number.keyword, dimless, number.deflt, number.low, number.high
        );

        wordList allowed(types);
        allowed.append("none");
        type = dictionaryInput::getWord(dict, "type", allowed);
        if (type == "none")
        {
            value.reset();
        }
        else if (!isPossible || isCoarse)
        {
            dictionaryInput::badValue
            (
                dict, "type", type,
                isCoarse
              ? "none, with coarseGraining"
              : "none, with the chosen type of voidFraction"
            );
        }
    }
    if (!isPossible || isCoarse)
    {
        value.reset();
    }
    return {type, value};
}
