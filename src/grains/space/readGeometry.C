/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readGeometry.H"

#include "dictionaryInput.H"
#include "OStringStream.H"

namespace Foam
{
namespace
{

//- Squares of larger numbers would be more than a number holds
const scalar largest = 1e15;

vector readVector
(
    const dictionary& dict,
    const word& keyword,
    const string& example
)
{
    const string allowed(example + ", of components up to 1e15");
    const vector v(dictionaryInput::getAs<vector>(dict, keyword, allowed));
    if (cmptMax(cmptMag(v)) > largest)
    {
        dictionaryInput::badValue
        (
            dict, keyword, dictionaryInput::written(dict, keyword), allowed
        );
    }
    return v;
}

}
}


template<int D>
nscd::Box<D> Foam::readBox
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    const string allowed
    (
        D == 2
      ? "two corners of a box in the plane of the mesh, as (0 0 0) (1 1 0)"
      : "two corners of a box, as (0 0 0) (1 1 1)"
    );
    if (!dict.found("box"))
    {
        dictionaryInput::missing(dict, "box", allowed);
    }
    ITstream& is = dict.lookup("box");

    // Two vectors of three numbers, with their brackets
    if (is.size() != 10)
    {
        dictionaryInput::badValue
        (
            dict, "box", dictionaryInput::written(dict, "box"), allowed
        );
    }
    point first(Zero), second(Zero);
    const string error
    (
        dictionaryInput::errorOf([&] { is >> first >> second; })
    );
    if (error.size() || max(mag(first), mag(second)) > largest)
    {
        dictionaryInput::badValue
        (
            dict, "box", dictionaryInput::written(dict, "box"), allowed
        );
    }
    const nscd::Vector<D> a(space.fromSpace(first));
    const nscd::Vector<D> b(space.fromSpace(second));
    const nscd::Box<D> result{a.cwiseMin(b), a.cwiseMax(b)};

    if ((result.upper - result.lower).minCoeff() <= 0)
    {
        OStringStream value;
        value << first << ' ' << second;
        dictionaryInput::badValue(dict, "box", value.str(), allowed);
    }
    return result;
}


template<int D>
nscd::Vector<D> Foam::readDirection
(
    const dictionary& dict,
    const word& keyword,
    const grainSpace<D>& space
)
{
    const vector v(readVector(dict, keyword, "a vector, as (1 0 0)"));
    if (mag(v) < SMALL || !space.holds(v))
    {
        OStringStream value;
        value << v;
        dictionaryInput::badValue
        (
            dict, keyword, value.str(),
            D == 2
          ? "a vector in the plane of the mesh, not zero"
          : "a vector that is not zero"
        );
    }
    return space.fromSpace(v);
}


template<int D>
nscd::Vector<D> Foam::readPoint
(
    const dictionary& dict,
    const word& keyword,
    const grainSpace<D>& space
)
{
    return space.fromSpace(readVector(dict, keyword, "a point, as (0 0 1)"));
}


template<int D>
Foam::Pair<nscd::Vector<D>> Foam::readPlane
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    return
    {
        readPoint(dict, "point", space),
        readDirection(dict, "normal", space).normalized()
    };
}


template<int D>
nscd::Spin<D> Foam::readAxis
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    const vector v(readVector(dict, "axis", "a vector, as (1 0 0)"));
    if (mag(v) < SMALL || !space.holdsSpin(v))
    {
        OStringStream value;
        value << v;
        dictionaryInput::badValue
        (
            dict, "axis", value.str(),
            D == 2
          ? "a vector normal to the plane of the mesh, not zero"
          : "a vector that is not zero"
        );
    }
    return space.spinFromSpace(v/mag(v));
}


template nscd::Box<2> Foam::readBox
(
    const dictionary&, const grainSpace<2>&
);
template nscd::Vector<2> Foam::readDirection
(
    const dictionary&, const word&, const grainSpace<2>&
);
template nscd::Vector<2> Foam::readPoint
(
    const dictionary&, const word&, const grainSpace<2>&
);
template nscd::Spin<2> Foam::readAxis
(
    const dictionary&, const grainSpace<2>&
);
template Foam::Pair<nscd::Vector<2>> Foam::readPlane
(
    const dictionary&, const grainSpace<2>&
);

template nscd::Box<3> Foam::readBox
(
    const dictionary&, const grainSpace<3>&
);
template nscd::Vector<3> Foam::readDirection
(
    const dictionary&, const word&, const grainSpace<3>&
);
template nscd::Vector<3> Foam::readPoint
(
    const dictionary&, const word&, const grainSpace<3>&
);
template nscd::Spin<3> Foam::readAxis
(
    const dictionary&, const grainSpace<3>&
);
template Foam::Pair<nscd::Vector<3>> Foam::readPlane
(
    const dictionary&, const grainSpace<3>&
);
