/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxInjection.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(grainInjection, grainInjectionTypes, box)

template<int D>
Foam::grainInjectionTypes::box<D>::box
(
    const dictionary& dict,
    const grainProperties<D>& properties
)
:
    grainInjection<D>(dict, properties),
    box_(readBox(dict, properties.space()))
{
    this->checkKeywords(dict, {"box"});

    const double width = (box_.upper - box_.lower).minCoeff();
    if (width < 2*this->largest()*(1 - 1e-9))
    {
        dictionaryInput::badValue
        (
            dict, "box", "with a width of " + Foam::name(width) + " m",
            "boxes that hold the largest grain, of radius "
          + Foam::name(this->largest()) + " m"
        );
    }
    const label inside = properties.space().findCell
    (
        properties.wrapped(0.5*(box_.lower + box_.upper))
    );
    if (returnReduce(inside, maxOp<label>()) < 0)
    {
        dictionaryInput::badValue
        (
            dict, "box", "with its middle outside the mesh",
            "boxes in the mesh"
        );
    }
}


template<int D>
bool Foam::grainInjectionTypes::box<D>::draw
(
    nscd::Random& random,
    const scalar radius,
    const bool,
    nscd::Vector<D>& x
) const
{
    for (int d = 0; d < D; ++d)
    {
        const double lower = box_.lower[d] + radius;
        x[d] = random.uniform(lower, max(lower, box_.upper[d] - radius));
    }
    return true;
}
