/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchesOutlet.H"

#include "dictionaryInput.H"
#include "emptyPolyPatch.H"
#include "PstreamReduceOps.H"
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
    patches_(wallPieces::selectedPatches(dict, space.mesh()))
{
    dictionaryInput::checkKeywords(dict, {"type", "patches"});
}


template<int D>
Foam::Pair<Foam::scalar> Foam::grainOutletTypes::patches<D>::distances
(
    const point& p
) const
{
    Pair<scalar> nearest(GREAT, GREAT);
    for (const polyPatch& patch : space_.mesh().boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(patch) && !patch.coupled())
        {
            scalar& d = nearest[patches_.found(patch.index()) ? 0 : 1];
            for (const face& f : patch)
            {
                d = min(d, f.nearestPoint(p, patch.points()).distance());
            }
        }
    }
    reduce(nearest.first(), minOp<scalar>());
    reduce(nearest.second(), minOp<scalar>());
    return nearest;
}


template<int D>
void Foam::grainOutletTypes::patches<D>::mark
(
    const nscd::Vectors<D>& centres,
    const boolList& outside,
    std::vector<bool>& gone
) const
{
    forAll(outside, i)
    {
        if (outside[i])
        {
            const Pair<scalar> d
            (
                distances(space_.positionInSpace(centres[i]))
            );
            gone[i] = gone[i] || d.first() <= d.second();
        }
    }
}
