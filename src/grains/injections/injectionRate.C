/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "injectionRate.H"

#include "dictionaryInput.H"

const Foam::wordList Foam::injectionRate::keywords
({
    "massRate", "volumeRate", "numberRate", "start", "end", "total"
});


Foam::injectionRate::injectionRate(const dictionary& dict, const scalar now)
:
    dict_(dict),
    start_
    (
        dictionaryInput::getScalarOrDefault(dict, "start", dimTime, 0, -GREAT)
    ),
    end_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict, "end", dimTime, GREAT, start_
        )
    ),
    total_
    (
        dict.found("total")
      ? dictionaryInput::getAs<scalar>(dict, "total", "a value >= 0")
      : GREAT
    ),
    owed_(0),
    paid_(0),
    until_(now)
{
    for (const char* keyword : {"massRate", "volumeRate", "numberRate"})
    {
        if (dict.found(keyword))
        {
            if (keyword_.size())
            {
                dictionaryInput::badValue
                (
                    dict, keyword, "beside " + keyword_,
                    "one of massRate, volumeRate and numberRate"
                );
            }
            keyword_ = keyword;
        }
    }
    if (keyword_.empty())
    {
        dictionaryInput::badValue
        (
            dict, "massRate", "none",
            "one of massRate, volumeRate and numberRate"
        );
    }
    if (total_ < 0)
    {
        dictionaryInput::badValue
        (
            dict, "total", Foam::name(total_), "a value >= 0"
        );
    }
    readRate();
}


void Foam::injectionRate::readRate()
{
    // Function1's own errors name neither the file nor the keyword
    string message;
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    try
    {
        rate_ = Function1<scalar>::New(keyword_, dict_);
    }
    catch (const Foam::error& err)
    {
        message = err.message();
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

    if (!message.empty())
    {
        dictionaryInput::badValue
        (
            dict_, keyword_, message,
            "a number or one of OpenFOAM's functions of time"
        );
    }
    const scalar first = max(start_, until_);
    for (label i = 0; i <= 1000; ++i)
    {
        const scalar t = first + i*1e-3*min(end_ - first, scalar(1000));
        const scalar rate = rate_->value(t);
        if (rate < 0)
        {
            dictionaryInput::badValue
            (
                dict_, keyword_,
                Foam::name(rate) + " at time " + Foam::name(t) + " s",
                "rates >= 0"
            );
        }
    }
}


Foam::scalar Foam::injectionRate::amount(const grainTally& grain) const
{
    return
        keyword_ == "massRate" ? grain.mass
      : keyword_ == "volumeRate" ? grain.volume
      : grain.number;
}


Foam::scalar Foam::injectionRate::integral
(
    const scalar from,
    const scalar to
) const
{
    // Tables have an integral only within their times, other functions none
    constexpr label parts = 16;

    const scalar part = (to - from)/parts;
    scalar sum = 0.5*(rate_->value(from) + rate_->value(to));
    for (label i = 1; i < parts; ++i)
    {
        sum += rate_->value(from + i*part);
    }
    return part*sum;
}


Foam::scalar Foam::injectionRate::owe(const scalar now)
{
    const scalar from = max(until_, start_);
    const scalar to = min(now, end_);
    const scalar more =
        to > from ? max(integral(from, to), scalar(0)) : scalar(0);
    owed_ += more;
    until_ = now;
    return more;
}


void Foam::injectionRate::requireFew
(
    const scalar due,
    const grainTally& grain
) const
{
    constexpr scalar most = 1e5;

    const scalar number = due/amount(grain);
    if (number > most)
    {
        dictionaryInput::badValue
        (
            dict_, keyword_, dictionaryInput::written(dict_, keyword_),
            "rates with which at most 1e5 grains come in in a time step; with"
            " this one and a grain of " + Foam::name(grain.mass)
          + " kg they are " + Foam::name(number)
        );
    }
}


bool Foam::injectionRate::isWithinTotal(const grainTally& grain) const
{
    return paid_ + amount(grain) <= total_*(1 + 1e-9);
}


bool Foam::injectionRate::owes(const grainTally& grain) const
{
    // A sum of steps is right to round-off
    return owed_ >= amount(grain)*(1 - 1e-9) && isWithinTotal(grain);
}


void Foam::injectionRate::pay(const grainTally& grain)
{
    owed_ -= amount(grain);
    paid_ += amount(grain);
}


void Foam::injectionRate::write(dictionary& state) const
{
    state.add("owed", owed_);
    state.add("paid", paid_);
    state.add("until", until_);
}


void Foam::injectionRate::read(const dictionary& state)
{
    owed_ = state.get<scalar>("owed");
    paid_ = state.get<scalar>("paid");
    until_ = state.get<scalar>("until");
}
