/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainRegion.H"

#include "selected.H"

namespace Foam
{
    makeSelectable(grainRegion)
}


template<int D>
Foam::autoPtr<Foam::grainRegion<D>> Foam::grainRegion<D>::New
(
    const dictionary& dict,
    const grainSpace<D>& space
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict, space);
}


template class Foam::grainRegion<2>;
template class Foam::grainRegion<3>;
