/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Magnus.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace liftLaws
{
    defineTypeNameAndDebug(Magnus, 0);
    addToRunTimeSelectionTable(liftLaw, Magnus, dictionary);
}
}


Foam::liftLaws::Magnus::Magnus(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type", "shape"});
}


Foam::vector Foam::liftLaws::Magnus::force
(
    const vector& w,
    const vector& vorticity,
    const vector& spin,
    const scalar,
    const scalar rho,
    const scalar
) const
{
    return 0.75*rho*(w ^ (spin - 0.5*vorticity));
}
