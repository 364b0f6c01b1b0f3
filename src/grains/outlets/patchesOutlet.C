/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchesOutlet.H"

#include "dictionaryInput.H"
#include "wallPieces.H"

addToSelection(grainOutlet, grainOutletTypes, patches)

template<int D>
Foam::grainOutletTypes::patches<D>::patches
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    space_(space),
    patches_(wallPieces::selectedPatches(dict, space.mesh())),
    distance_(space.mesh(), patches_)
{
    dictionaryInput::checkKeywords(dict, {"type", "patches"});
}


template<int D>
Foam::grainOutletTypes::patches<D>::patches
(
    const labelList& patches,
    const grainSpace<D>& space
)
:
    space_(space),
    patches_(patches),
    distance_(space.mesh(), patches_)
{}


template<int D>
void Foam::grainOutletTypes::patches<D>::mark
(
    const nscd::Vectors<D>&,
    const nscd::Vectors<D>& centres,
    const boolList& outside,
    std::vector<bool>& gone
) const
{
    DynamicList<label> out;
    DynamicList<point> x;
    forAll(outside, i)
    {
        if (outside[i])
        {
            out.append(i);
            x.append(space_.positionInSpace(centres[i]));
        }
    }
    const boolList passed(distance_.arePatchesNearest(x));
    forAll(out, k)
    {
        gone[out[k]] = gone[out[k]] || passed[k];
    }
}


template class Foam::grainOutletTypes::patches<2>;
template class Foam::grainOutletTypes::patches<3>;
