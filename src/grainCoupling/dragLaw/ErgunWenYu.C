/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ErgunWenYu.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

#include "dragOfSphere.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(ErgunWenYu, 0);
    addToRunTimeSelectionTable(dragLaw, ErgunWenYu, dictionary);
}
}


Foam::dragLaws::ErgunWenYu::ErgunWenYu(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::ErgunWenYu::gamma
(
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    if (eps < 0.8)
    {
        return 150*(1 - eps)/eps*mu/sqr(d) + 1.75*rho*w/d;
    }
    return std::pow(eps, -2.65)*dragOfSphere(eps*rho*w*d/mu)*mu/sqr(d);
}
