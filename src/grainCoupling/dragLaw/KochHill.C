/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "KochHill.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(KochHill, 0);
    addToRunTimeSelectionTable(dragLaw, KochHill, dictionary);
}
}


Foam::dragLaws::KochHill::KochHill(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type"});
}


Foam::scalar Foam::dragLaws::KochHill::gamma
(
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
) const
{
    const scalar phi = 1 - eps;
    const scalar F3 = 0.0673 + 0.212*phi + 0.0232/pow5(eps);
    scalar F0 = 10*phi/pow3(eps);
    if (phi < 0.4)
    {
        const scalar logarithm = phi > 0 ? phi*std::log(phi) : 0;
        F0 =
            (1 + 3*std::sqrt(phi/2) + 135.0/64*logarithm + 16.14*phi)
           /(1 + 0.681*phi - 8.48*sqr(phi) + 8.16*pow3(phi));
    }
    return 18*sqr(eps)*(F0 + 0.5*F3*eps*rho*w*d/mu)*mu/sqr(d);
}
