/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Maxwell.H"
#include "noEffectiveConductivity.H"
#include "ZehnerSchluender.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace effectiveConductivities
{
    defineTypeNameAndDebug(none, 0);
    addToRunTimeSelectionTable(effectiveConductivity, none, dictionary);

    defineTypeNameAndDebug(Maxwell, 0);
    addToRunTimeSelectionTable(effectiveConductivity, Maxwell, dictionary);

    defineTypeNameAndDebug(ZehnerSchluender, 0);
    addToRunTimeSelectionTable
    (
        effectiveConductivity, ZehnerSchluender, dictionary
    );
}
}

using namespace Foam::dictionaryInput;

Foam::effectiveConductivities::none::none(const dictionary& dict)
{
    checkKeywords(dict, {"type"});
}


Foam::effectiveConductivities::Maxwell::Maxwell(const dictionary& dict)
{
    checkKeywords(dict, {"type", "shape"});
}


Foam::effectiveConductivities::ZehnerSchluender::ZehnerSchluender
(
    const dictionary& dict
)
{
    checkKeywords(dict, {"type", "shape"});
}


Foam::scalar Foam::effectiveConductivities::ZehnerSchluender::ratioOf
(
    const scalar eps,
    const scalar k
)
{
    using constant::mathematical::pi;
    const scalar phi = min(1 - eps, pi/std::sqrt(18.0));
    if (phi < SMALL)
    {
        return 1;
    }
    const scalar root = std::sqrt(phi);
    if (k < SMALL)
    {
        return 1 - root;
    }
    const scalar B = 1.25*std::pow(phi/(1 - phi), 10.0/9.0);
    const scalar d = 1 - B/k;

    // The bracket over d, where it is zero in powers of d
    scalar inGrains = 0;
    if (mag(d) < 0.02)
    {
        for (label m = 8; m > 0; --m)
        {
            inGrains = inGrains*d + (B - 1)/(m + 2) + 1.0/(m + 1);
        }
    }
    else
    {
        inGrains =
            ((B - B/k)*std::log(k/B)/sqr(d) - 0.5*(B + 1) - (B - 1)/d)/d;
    }
    return 1 - root + 2*root*inGrains;
}
