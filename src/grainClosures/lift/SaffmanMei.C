/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SaffmanMei.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace liftLaws
{
    defineTypeNameAndDebug(SaffmanMei, 0);
    addToRunTimeSelectionTable(liftLaw, SaffmanMei, dictionary);
}
}


Foam::liftLaws::SaffmanMei::SaffmanMei(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type", "shape"});
}


Foam::scalar Foam::liftLaws::SaffmanMei::correction
(
    const scalar Re,
    const scalar beta
)
{
    if (Re > 40)
    {
        return 0.0524*Foam::sqrt(beta*Re);
    }
    const scalar far = 0.3314*Foam::sqrt(beta);
    return (1 - far)*Foam::exp(-0.1*Re) + far;
}


Foam::vector Foam::liftLaws::SaffmanMei::force
(
    const vector& w,
    const vector& vorticity,
    const vector&,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const scalar speed = mag(w);
    const scalar omega = mag(vorticity);
    if (speed < VSMALL || omega < VSMALL)
    {
        return Zero;
    }

    const scalar C = correction(rho*speed*d/mu, 0.5*omega*d/speed);
    return
        6/constant::mathematical::pi*1.615*C*Foam::sqrt(rho*mu/omega)/d
       *(w ^ vorticity);
}
