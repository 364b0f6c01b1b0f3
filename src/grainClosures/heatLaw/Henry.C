/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Henry.H"

#include "addToRunTimeSelectionTable.H"
#include "diFeliceDip.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace heatLaws
{
    defineTypeNameAndDebug(Henry, 0);
    addToRunTimeSelectionTable(heatLaw, Henry, dictionary);
}
}


Foam::heatLaws::Henry::Henry(const dictionary& dict)
:
    dip_
    (
        dictionaryInput::getScalarOrDefault(dict, "dip", dimless, 1, 0, 1.8)
    ),
    PrExponent_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict, "PrExponent", dimless, 0.4, 0, 1
        )
    )
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "shape", "dip", "PrExponent"}
    );
}


Foam::scalar Foam::heatLaws::Henry::Nu
(
    const scalar dip,
    const scalar PrExponent,
    const scalar eps,
    const scalar slipRe,
    const scalar Pr
)
{
    const scalar Re = eps*slipRe;
    const scalar voidage =
        std::pow(eps, -1.8 + dip*dragLaws::diFeliceDip(Re));
    const scalar analogy = (Re + 500)/(0.11*std::pow(Re, 1.4) + Re + 500);

    return
        voidage*analogy*sqr(0.18*std::sqrt(Re) + 1.39)
       *std::pow(Pr, PrExponent);
}
