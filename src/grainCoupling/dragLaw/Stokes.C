/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Stokes.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(Stokes, 0);
    addToRunTimeSelectionTable(dragLaw, Stokes, dictionary);
}
}


Foam::dragLaws::Stokes::Stokes(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::Stokes::gamma
(
    const scalar,
    const scalar,
    const scalar d,
    const scalar,
    const scalar mu
) const
{
    return 18*mu/sqr(d);
}
