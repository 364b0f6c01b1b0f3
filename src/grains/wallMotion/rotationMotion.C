/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rotationMotion.H"

#include "dictionaryInput.H"
#include "readGeometry.H"

addToSelection(wallMotion, wallMotions, rotation)

template<int D>
Foam::wallMotions::rotation<D>::rotation
(
    const dictionary& dict,
    const grainSpace<D>& space
)
:
    spin_(readAxis(dict, space)),
    during_(dict)
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "origin", "axis", "omega", "rpm", "start", "end"}
    );

    this->origin_ = readPoint(dict, "origin", space);

    if (dict.found("omega") == dict.found("rpm"))
    {
        dictionaryInput::badValue
        (
            dict, "omega", dict.found("rpm") ? "besides rpm" : "no value",
            "one of omega [rad/s] and rpm"
        );
    }
    spin_ *=
        dict.found("omega")
      ? dictionaryInput::getScalar(dict, "omega", dimless/dimTime, -GREAT)
      : dictionaryInput::getScalar(dict, "rpm", dimless, -GREAT)
       *constant::mathematical::twoPi/60;
}


template<int D>
nscd::Spin<D> Foam::wallMotions::rotation<D>::spin
(
    const scalar t,
    const scalar deltaT
) const
{
    return during_.share(t, deltaT)*spin_;
}
