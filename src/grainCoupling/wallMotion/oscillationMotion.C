/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oscillationMotion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, oscillation)

template<int D>
Foam::wallMotions::oscillation<D>::oscillation
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    direction_(readDirection(dict, "direction", space).normalized()),
    amplitude_(dictionaryInput::getScalar(dict, "amplitude", dimLength, 0)),
    frequency_
    (
        dictionaryInput::getPositive(dict, "frequency", dimless/dimTime)
    ),
    start_
    (
        dictionaryInput::getScalarOrDefault(dict, "start", dimTime, 0, -GREAT)
    )
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "direction", "amplitude", "frequency", "start"}
    );
}


template<int D>
Foam::scalar Foam::wallMotions::oscillation<D>::displacement
(
    const scalar t
) const
{
    return
        amplitude_
       *std::sin
        (
            constant::mathematical::twoPi*frequency_*max(t - start_, 0.0)
        );
}


template<int D>
nscd::WallBody<D> Foam::wallMotions::oscillation<D>::body() const
{
    return nscd::WallBody<D>();
}


template<int D>
void Foam::wallMotions::oscillation<D>::set
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
        bodyi,
        (displacement(t + deltaT) - displacement(t))/deltaT*direction_,
        nscd::Spin<D>::Zero()
    );
}
