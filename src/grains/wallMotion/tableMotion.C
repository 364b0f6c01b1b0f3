/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableMotion.H"

#include "dictionaryInput.H"
#include "functionEntries.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, table)

namespace
{

using namespace Foam;

// Function1's own errors name neither the file nor the keyword
template<class Type>
autoPtr<Function1<Type>> readFunction(const dictionary& dict, const word& keyword)
{
    autoPtr<Function1<Type>> result;
    const string message
    (
        dictionaryInput::errorOf
        (
            [&] { result = Function1<Type>::New(keyword, dict); }
        )
    );
    if (!message.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Keyword '" << keyword << "': " << message.c_str() << nl
            << "    allowed: a function of time; the times of a table increase"
            << exit(FatalIOError);
    }
    return result;
}

}


template<int D>
Foam::wallMotions::table<D>::table
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    space_(space),
    axis_(nscd::Spin<D>::Zero())
{
    wordList allowed({"type", "origin", "axis"});
    allowed.append
    (
        dictionaryInput::functionKeywords(dict, {"displacement", "angle"})
    );
    dictionaryInput::checkKeywords(dict, allowed);

    if (!dict.found("displacement") && !dict.found("angle"))
    {
        dictionaryInput::badValue
        (
            dict, "displacement", "none", "one of displacement and angle, or both"
        );
    }
    if (dict.found("displacement"))
    {
        displacement_ = readFunction<vector>(dict, "displacement");
    }
    if (dict.found("angle"))
    {
        angle_ = readFunction<scalar>(dict, "angle");
        this->origin_ = readPoint(dict, "origin", space);
        axis_ = readAxis(dict, space);
    }
}


template<int D>
nscd::Vector<D> Foam::wallMotions::table<D>::velocity
(
    const scalar t,
    const scalar deltaT
) const
{
    if (!displacement_)
    {
        return nscd::Vector<D>::Zero();
    }
    return space_.fromSpace
    (
        (displacement_->value(t + deltaT) - displacement_->value(t))/deltaT
    );
}


template<int D>
nscd::Spin<D> Foam::wallMotions::table<D>::spin
(
    const scalar t,
    const scalar deltaT
) const
{
    if (!angle_)
    {
        return nscd::Spin<D>::Zero();
    }
    return (angle_->value(t + deltaT) - angle_->value(t))/deltaT*axis_;
}
