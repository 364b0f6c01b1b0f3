/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Beetstra.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(Beetstra, 0);
    addToRunTimeSelectionTable(dragLaw, Beetstra, dictionary);
}
}


Foam::dragLaws::Beetstra::Beetstra(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::Beetstra::gamma
(
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const scalar phi = 1 - eps;
    const scalar Re = eps*rho*w*d/mu;
    scalar F = 10*phi/sqr(eps) + sqr(eps)*(1 + 1.5*std::sqrt(phi));
    if (Re > 0)
    {
        F +=
            0.413/24/sqr(eps)
           *((1/eps + 3*phi*eps)*Re + 8.4*std::pow(Re, 0.657))
           /(1 + std::pow(10, 3*phi)*std::pow(Re, -0.5*(1 + 4*phi)));
    }
    return 18*eps*F*mu/sqr(d);
}
