/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "functionOfTemperature.H"

#include "dictionaryInput.H"
#include "ITstream.H"
#include "StringStream.H"

Foam::functionOfTemperature::functionOfTemperature
(
    const dictionary& dict,
    const word& keyword,
    const dimensionSet& dims
)
:
    dict_(dict),
    keyword_(keyword)
{
    OStringStream unit;
    unit << dims;
    const string allowed
    (
        "a number > 0 " + unit.str()
      + ", or a function of the temperature: table, polynomial, ..."
    );
    if (!dict.found(keyword))
    {
        dictionaryInput::missing(dict, keyword, allowed);
    }
    if (isFunction(dict, keyword))
    {
        const auto read = [&] { function_ = Function1<scalar>::New(keyword, dict); };
        if (dictionaryInput::errorOf(read).size())
        {
            dictionaryInput::badValue
            (
                dict, keyword, dictionaryInput::written(dict, keyword), allowed
            );
        }
    }
    else
    {
        const scalar value = dictionaryInput::getPositive(dict, keyword, dims);
        dictionary constant;
        constant.add(keyword, value);
        function_ = Function1<scalar>::New(keyword, constant);
    }
}


bool Foam::functionOfTemperature::isFunction
(
    const dictionary& dict,
    const word& keyword
)
{
    if (!dict.found(keyword))
    {
        return false;
    }
    const ITstream& written = dict.lookup(keyword);
    return written.size() && written[0].isWord();
}


Foam::scalar Foam::functionOfTemperature::at(const scalar T) const
{
    const scalar value = function_->value(T);
    if (!(value > 0))
    {
        dictionaryInput::badValue
        (
            dict_, keyword_, Foam::name(value) + " at " + Foam::name(T) + " K",
            "a value > 0 at all temperatures that occur"
        );
    }
    return value;
}


void Foam::functionOfTemperature::set
(
    volScalarField& property,
    const volScalarField& T
) const
{
    forAll(property, celli)
    {
        property[celli] = at(T[celli]);
    }
    forAll(property.boundaryField(), patchi)
    {
        const fvPatchScalarField& TPatch = T.boundaryField()[patchi];
        fvPatchScalarField& patch = property.boundaryFieldRef()[patchi];
        forAll(patch, facei)
        {
            patch[facei] = at(TPatch[facei]);
        }
    }
}
