/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "functionOfTemperature.H"

#include "dictionaryInput.H"
#include "functionEntries.H"
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
    if (dictionaryInput::isFunction(dict, keyword))
    {
        const string message
        (
            dictionaryInput::errorOf
            (
                [&] { function_ = Function1<scalar>::New(keyword, dict); }
            )
        );
        if (message.size())
        {
            dictionaryInput::badValue
            (
                dict, keyword,
                dictionaryInput::written(dict, keyword) + ": " + message, allowed
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
