/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Batchelor.H"
#include "Einstein.H"
#include "KriegerDougherty.H"
#include "noEffectiveViscosity.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace effectiveViscosities
{
    defineTypeNameAndDebug(none, 0);
    addToRunTimeSelectionTable(effectiveViscosity, none, dictionary);

    defineTypeNameAndDebug(Einstein, 0);
    addToRunTimeSelectionTable(effectiveViscosity, Einstein, dictionary);

    defineTypeNameAndDebug(Batchelor, 0);
    addToRunTimeSelectionTable(effectiveViscosity, Batchelor, dictionary);

    defineTypeNameAndDebug(KriegerDougherty, 0);
    addToRunTimeSelectionTable(effectiveViscosity, KriegerDougherty, dictionary);
}
}

using namespace Foam::dictionaryInput;

Foam::effectiveViscosities::none::none(const dictionary& dict)
{
    checkKeywords(dict, {"type"});
}


Foam::effectiveViscosities::Einstein::Einstein(const dictionary& dict)
:
    intrinsic_(getScalarOrDefault(dict, "intrinsic", dimless, 2.5, 0))
{
    checkKeywords(dict, {"type", "intrinsic"});
}


Foam::effectiveViscosities::Batchelor::Batchelor(const dictionary& dict)
:
    quadratic_(getScalarOrDefault(dict, "quadratic", dimless, 7.6, 0))
{
    checkKeywords(dict, {"type", "quadratic"});
}


Foam::effectiveViscosities::KriegerDougherty::KriegerDougherty
(
    const dictionary& dict
)
:
    maxFraction_(getScalar(dict, "maxFraction", dimless, 0.1, 1)),
    exponent_(getScalarOrDefault(dict, "exponent", dimless, 2, 0)),
    maxRatio_(getScalarOrDefault(dict, "maxRatio", dimless, 1000, 1))
{
    checkKeywords(dict, {"type", "maxFraction", "exponent", "maxRatio"});
}


Foam::scalar Foam::effectiveViscosities::KriegerDougherty::ratio
(
    const scalar phi,
    const scalar maxFraction,
    const scalar exponent,
    const scalar maxRatio
)
{
    if (phi >= maxFraction)
    {
        return maxRatio;
    }
    // Before it overflows
    const scalar logarithm = -exponent*std::log1p(-phi/maxFraction);
    return logarithm < std::log(maxRatio) ? std::exp(logarithm) : maxRatio;
}
