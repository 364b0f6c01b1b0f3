/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "thesisPrinted.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(thesisPrinted, 0);
    addToRunTimeSelectionTable(dragLaw, thesisPrinted, dictionary);
}
}


Foam::dragLaws::thesisPrinted::thesisPrinted(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::thesisPrinted::gamma
(
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    return
        std::pow(eps, -2.8)*sqr(0.77*std::sqrt(eps*rho*w*d/mu) + 5.88)*mu/sqr(d);
}
