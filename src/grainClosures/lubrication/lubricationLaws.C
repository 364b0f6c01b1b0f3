/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Davis.H"
#include "Legendre.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace lubricationLaws
{
    defineTypeNameAndDebug(Davis, 0);
    addToRunTimeSelectionTable(lubricationLaw, Davis, dictionary);

    defineTypeNameAndDebug(Legendre, 0);
    addToRunTimeSelectionTable(lubricationLaw, Legendre, dictionary);
}
}

using namespace Foam::dictionaryInput;

Foam::lubricationLaws::Davis::Davis(const dictionary& dict)
:
    roughness_(getScalar(dict, "roughness", dimless, 1e-8, 0.1)),
    reach_(getScalarOrDefault(dict, "reach", dimless, 1, roughness_, 1))
{
    checkKeywords(dict, {"type", "roughness", "reach"});
}


Foam::scalar Foam::lubricationLaws::Davis::restitution
(
    const scalar e,
    const scalar St,
    const scalar ratio
)
{
    return max(e - (1 + e)*Foam::log(ratio)/St, scalar(0));
}


Foam::lubricationLaws::Legendre::Legendre(const dictionary& dict)
:
    beta_(getScalarOrDefault(dict, "beta", dimless, 35, 0))
{
    checkKeywords(dict, {"type", "beta"});
}


Foam::scalar Foam::lubricationLaws::Legendre::restitution
(
    const scalar e,
    const scalar St,
    const scalar beta
)
{
    return e*Foam::exp(-beta/St);
}
