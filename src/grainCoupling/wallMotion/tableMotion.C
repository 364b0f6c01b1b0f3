/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableMotion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, table)

namespace
{

using namespace Foam;

// Function1's own errors name neither the file nor the keyword
template<class Type>
autoPtr<Function1<Type>> readFunction(const dictionary& dict, const word& keyword)
{
    string message;
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    autoPtr<Function1<Type>> result;
    try
    {
        result = Function1<Type>::New(keyword, dict);
    }
    catch (const Foam::error& err)
    {
        message = err.message();
    }
    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

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
    origin_(nscd::Vector<D>::Zero()),
    axis_(nscd::Spin<D>::Zero())
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "displacement", "angle", "origin", "axis"}
    );

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
        origin_ = space.fromSpace(dict.get<point>("origin"));
        axis_ = readAxis(dict, space);
    }
}


template<int D>
nscd::WallBody<D> Foam::wallMotions::table<D>::body() const
{
    nscd::WallBody<D> result;
    result.position = origin_;
    return result;
}


template<int D>
void Foam::wallMotions::table<D>::set
(
    nscd::ContactDynamics<D>& dynamics,
    const label bodyi,
    const scalar t,
    const scalar deltaT,
    const nscd::Vector<D>& g
) const
{
    nscd::Vector<D> velocity(nscd::Vector<D>::Zero());
    nscd::Spin<D> spin(nscd::Spin<D>::Zero());
    if (displacement_)
    {
        velocity = space_.fromSpace
        (
            (displacement_->value(t + deltaT) - displacement_->value(t))/deltaT
        );
    }
    if (angle_)
    {
        spin = (angle_->value(t + deltaT) - angle_->value(t))/deltaT*axis_;
    }
    dynamics.setWallMotion(bodyi, velocity, spin);
}
