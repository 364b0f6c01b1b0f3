/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryInput.H"

#include "OStringStream.H"
#include "userNames.H"

namespace
{

using namespace Foam;

scalar readChecked
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims
)
{
    OStringStream allowed;
    allowed << "a number with the dimensions " << dims << " or without any";
    if (!dict.found(keyword))
    {
        dictionaryInput::missing(dict, keyword, allowed.str());
    }

    const string text(dictionaryInput::written(dict, keyword));
    // Wrong dimensions would end in abort() and a stack trace
    scalar value = 0;
    const string message
    (
        dictionaryInput::errorOf
        (
            [&] { value = dimensionedScalar(keyword, dims, dict).value(); }
        )
    );

    if (!message.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "' has the value "
            << text.c_str() << nl << "    " << message.c_str() << nl
            << "    allowed: " << allowed.str().c_str() << exit(FatalIOError);
    }

    // Squares and cubes of it are numbers, too
    if
    (
        !std::isfinite(value)
     || (value != 0 && (mag(value) < 1e-100 || mag(value) > 1e100))
    )
    {
        dictionaryInput::badValue
        (
            dict, keyword, text,
            "a finite number, 0 or of a magnitude from 1e-100 to 1e100"
        );
    }
    return value;
}

string interval(const scalar value, const scalar low, const scalar high)
{
    OStringStream os;
    if (high >= labelMax && value < low)
    {
        os  << "a value >= " << low;
    }
    else
    {
        os  << "a value from " << low << " to " << high;
    }
    return os.str();
}

}


void Foam::dictionaryInput::badValue
(
    const dictionary& dict,
    const word& keyword,
    const string& value,
    const string& allowed
)
{
    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword.c_str() << "' has the value "
        << value.c_str() << nl
        << "    allowed: " << allowed.c_str()
        << exit(FatalIOError);
}


void Foam::dictionaryInput::missing
(
    const dictionary& dict,
    const word& keyword,
    const string& allowed
)
{
    FatalIOErrorInFunction(dict)
        << "Keyword '" << keyword.c_str() << "' is missing" << nl
        << "    allowed: " << allowed.c_str()
        << exit(FatalIOError);
}


Foam::string Foam::dictionaryInput::errorOf
(
    const std::function<void()>& read
)
{
    string message;
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    try
    {
        read();
    }
    catch (const error& err)
    {
        message = err.message();
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);
    return message;
}


void Foam::dictionaryInput::checkKeywords
(
    const dictionary& dict,
    const wordList& allowed
)
{
    forAllConstIters(dict, iter)
    {
        const word& keyword = iter().keyword();
        if (!allowed.found(keyword) && !isUserName(dict, keyword, allowed))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword '" << keyword << "'" << nl
                << "    allowed: " << listed(allowed).c_str()
                << " and names of your own that a $ uses"
                << exit(FatalIOError);
        }
    }
}


const Foam::dictionary& Foam::dictionaryInput::subDict
(
    const dictionary& dict,
    const word& keyword
)
{
    const dictionary* subPtr = dict.findDict(keyword);
    if (!subPtr && dict.found(keyword))
    {
        badValue
        (
            dict, keyword, written(dict, keyword),
            "a dictionary, " + keyword + " { ... }"
        );
    }
    if (!subPtr)
    {
        missing(dict, keyword, "a dictionary, " + keyword + " { ... }");
    }
    return *subPtr;
}


Foam::scalar Foam::dictionaryInput::getScalar
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims,
    const scalar low,
    const scalar high
)
{
    const scalar value = readChecked(dict, keyword, dims);

    if (value < low || value > high)
    {
        badValue(dict, keyword, name(value), interval(value, low, high));
    }
    return value;
}


Foam::scalar Foam::dictionaryInput::getScalarOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims,
    const scalar deflt,
    const scalar low,
    const scalar high
)
{
    return
        dict.found(keyword)
      ? getScalar(dict, keyword, dims, low, high)
      : deflt;
}


Foam::vector Foam::dictionaryInput::getVectorOrZero
(
    const dictionary& dict,
    const word& keyword
)
{
    const string allowed("a vector, as (0 0 1), of components up to 1e15");
    if (!dict.found(keyword))
    {
        return Zero;
    }
    const vector value(getAs<vector>(dict, keyword, allowed));
    if (cmptMax(cmptMag(value)) > 1e15)
    {
        badValue(dict, keyword, written(dict, keyword), allowed);
    }
    return value;
}


Foam::scalar Foam::dictionaryInput::getPositive
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims
)
{
    const scalar value = readChecked(dict, keyword, dims);

    if (value <= 0)
    {
        badValue(dict, keyword, name(value), "a value > 0");
    }
    return value;
}


Foam::scalar Foam::dictionaryInput::getPositiveOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims,
    const scalar deflt
)
{
    return dict.found(keyword) ? getPositive(dict, keyword, dims) : deflt;
}


Foam::label Foam::dictionaryInput::getLabel
(
    const dictionary& dict,
    const word& keyword,
    const label low,
    const label high
)
{
    const label value =
        getAs<label>(dict, keyword, "a whole number of at most " + name(labelMax));

    if (value < low || value > high)
    {
        badValue(dict, keyword, name(value), interval(value, low, high));
    }
    return value;
}


Foam::label Foam::dictionaryInput::getLabelOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const label deflt,
    const label low,
    const label high
)
{
    return
        dict.found(keyword) ? getLabel(dict, keyword, low, high) : deflt;
}


void Foam::dictionaryInput::checkDimensions
(
    const IOobject& io,
    const dimensionSet& found,
    const dimensionSet& allowed
)
{
    if (found != allowed)
    {
        FatalErrorInFunction
            << "Keyword 'dimensions' of " << io.objectPath()
            << " has the value " << found << nl
            << "    allowed: " << allowed << exit(FatalError);
    }
}


Foam::string Foam::dictionaryInput::listed(const wordList& names)
{
    string result;
    for (const word& name : names)
    {
        result += (result.empty() ? "" : " ") + name;
    }
    return '(' + result + ')';
}
