/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Rong.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(Rong, 0);
    addToRunTimeSelectionTable(dragLaw, Rong, dictionary);
}
}


Foam::dragLaws::Rong::Rong(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::Rong::gamma
(
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    // The dip of the exponent vanishes on both sides; the floor only keeps the
    // logarithm finite at rest
    const scalar Re = eps*rho*w*d/mu;
    const scalar fromDip = 1.5 - std::log10(std::max(Re, 1e-20));
    const scalar beta =
        2.65*(eps + 1)
      - (5.3 - 3.5*eps)*sqr(eps)*std::exp(-0.5*fromDip*fromDip);

    return 0.75*std::pow(eps, 1 - beta)*sqr(0.63*std::sqrt(Re) + 4.8)*mu/sqr(d);
}
