/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "beyondOutlet.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(grainOutlet, grainOutletTypes, beyond)

template<int D>
Foam::grainOutletTypes::beyond<D>::beyond
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    dictionaryInput::checkKeywords(dict, {"type", "point", "normal"});

    const Pair<nscd::Vector<D>> plane(readPlane(dict, space));
    point_ = plane.first();
    normal_ = plane.second();
}


template<int D>
void Foam::grainOutletTypes::beyond<D>::mark
(
    const nscd::Vectors<D>&,
    const nscd::Vectors<D>& centres,
    const boolList&,
    std::vector<bool>& gone
) const
{
    for (std::size_t i = 0; i < gone.size(); ++i)
    {
        gone[i] = gone[i] || normal_.dot(centres[i] - point_) > 0;
    }
}
