/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceRegion.H"

#include "dictionaryInput.H"

addToSelection(grainRegion, grainRegions, surface)

template<int D>
Foam::grainRegions::surface<D>::surface
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    outline_(wallPieces::ofSurface(dict, space))
{
    dictionaryInput::checkKeywords(dict, {"type", "file", "scale"});
}
