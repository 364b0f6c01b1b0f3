/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "translationMotion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, translation)

template<int D>
Foam::wallMotions::translation<D>::translation
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    velocity_(readDirection(dict, "velocity", space)),
    during_(dict)
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "velocity", "start", "end"}
    );
}


template<int D>
nscd::Vector<D> Foam::wallMotions::translation<D>::velocity
(
    const scalar t,
    const scalar deltaT
) const
{
    return during_.share(t, deltaT)*velocity_;
}
