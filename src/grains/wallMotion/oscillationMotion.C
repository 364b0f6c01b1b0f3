/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oscillationMotion.H"

#include "dictionaryInput.H"
#include "OStringStream.H"
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
    ),
    dict_(dict)
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
nscd::Vector<D> Foam::wallMotions::oscillation<D>::velocity
(
    const scalar t,
    const scalar deltaT
) const
{
    return (displacement(t + deltaT) - displacement(t))/deltaT*direction_;
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
    if (deltaT > (1 + 1e-9)*maxDeltaT())
    {
        OStringStream allowed;
        allowed
            << "at most " << 1/(4*deltaT) << " Hz with steps of " << deltaT
            << " s, four in a period: the wall would move otherwise, or not at"
            << " all";
        dictionaryInput::badValue
        (
            dict_, "frequency", dictionaryInput::written(dict_, "frequency"),
            allowed.str()
        );
    }
    prescribed<D>::set(dynamics, bodyi, t, deltaT, g);
}
