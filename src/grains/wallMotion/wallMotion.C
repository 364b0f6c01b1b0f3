/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallMotion.H"

#include "selected.H"

namespace Foam
{
    makeSelectable(wallMotion)
}


template<int D>
Foam::autoPtr<Foam::wallMotion<D>> Foam::wallMotion<D>::New
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


template class Foam::wallMotion<2>;
template class Foam::wallMotion<3>;
