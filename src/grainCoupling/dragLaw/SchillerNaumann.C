/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SchillerNaumann.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

#include "dragOfSphere.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(SchillerNaumann, 0);
    addToRunTimeSelectionTable(dragLaw, SchillerNaumann, dictionary);
}
}


Foam::dragLaws::SchillerNaumann::SchillerNaumann(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::SchillerNaumann::gamma
(
    const scalar,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    return dragOfSphere(rho*w*d/mu)*mu/sqr(d);
}
