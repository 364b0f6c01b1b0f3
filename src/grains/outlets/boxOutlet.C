/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxOutlet.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(grainOutlet, grainOutletTypes, box)

template<int D>
Foam::grainOutletTypes::box<D>::box
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    box_(readBox(dict, space))
{
    dictionaryInput::checkKeywords(dict, {"type", "box"});
}


template<int D>
void Foam::grainOutletTypes::box<D>::mark
(
    const nscd::Vectors<D>& centres,
    const boolList&,
    std::vector<bool>& gone
) const
{
    const Eigen::AlignedBox<double, D> box(box_.lower, box_.upper);
    for (std::size_t i = 0; i < gone.size(); ++i)
    {
        gone[i] = gone[i] || box.contains(centres[i]);
    }
}
