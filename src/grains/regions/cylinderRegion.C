/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cylinderRegion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(grainRegion, grainRegions, cylinder)

template<int D>
Foam::grainRegions::cylinder<D>::cylinder
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    start_(readPoint(dict, "start", space)),
    axis_(readPoint(dict, "end", space) - start_),
    length_(axis_.norm()),
    radius_(dictionaryInput::getPositive(dict, "radius", dimLength))
{
    dictionaryInput::checkKeywords(dict, {"type", "start", "end", "radius"});

    if (dict.get<point>("start") == dict.get<point>("end"))
    {
        dictionaryInput::badValue
        (
            dict, "end", dictionaryInput::written(dict, "end"),
            "a point other than 'start'"
        );
    }
    if (length_ > 0)
    {
        axis_ /= length_;
    }
}


template<int D>
bool Foam::grainRegions::cylinder<D>::holds
(
    const nscd::Vector<D>& x,
    const scalar radius
) const
{
    const nscd::Vector<D> arm(x - start_);
    if (length_ <= 0)
    {
        return arm.norm() <= radius_ - radius;
    }
    const scalar along = arm.dot(axis_);
    return
        along >= radius
     && along <= length_ - radius
     && (arm - along*axis_).norm() <= radius_ - radius;
}
