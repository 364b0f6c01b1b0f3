/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainOutlet.H"

#include "selected.H"

namespace Foam
{
    makeSelectable(grainOutlet)
}


template<int D>
Foam::autoPtr<Foam::grainOutlet<D>> Foam::grainOutlet<D>::New
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


template class Foam::grainOutlet<2>;
template class Foam::grainOutlet<3>;
