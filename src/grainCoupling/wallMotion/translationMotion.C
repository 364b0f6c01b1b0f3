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
nscd::WallBody<D> Foam::wallMotions::translation<D>::body() const
{
    return nscd::WallBody<D>();
}


template<int D>
void Foam::wallMotions::translation<D>::set
(
    nscd::ContactDynamics<D>& dynamics,
    const label bodyi,
    const scalar t,
    const scalar deltaT,
    const nscd::Vector<D>& g
) const
{
    dynamics.setWallMotion
    (
        bodyi, during_.share(t, deltaT)*velocity_, nscd::Spin<D>::Zero()
    );
}
