/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "DallavalleDiFelice.H"

#include "addToRunTimeSelectionTable.H"
#include "diFeliceDip.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace dragLaws
{
    defineTypeNameAndDebug(DallavalleDiFelice, 0);
    addToRunTimeSelectionTable(dragLaw, DallavalleDiFelice, dictionary);
}
}


Foam::dragLaws::DallavalleDiFelice::DallavalleDiFelice(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type", "shape"});

    shapeFactor_ =
        dictionaryInput::getWord(dict, "shape", {"disc", "sphere"}) == "disc"
      ? disc
      : sphere;
}


Foam::scalar Foam::dragLaws::DallavalleDiFelice::gamma
(
    const scalar shapeFactor,
    const scalar eps,
    const scalar w,
    const scalar d,
    const scalar rho,
    const scalar mu
)
{
    const scalar Re = eps*rho*w*d/mu;
    const scalar exponent = 2.8 - 0.65*diFeliceDip(Re);
    const scalar root = shapeFactor*(0.63*std::sqrt(Re) + 4.8);

    return std::pow(eps, -exponent)*root*root*mu/(d*d);
}
