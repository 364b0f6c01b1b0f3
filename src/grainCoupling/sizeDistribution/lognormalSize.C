/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lognormalSize.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace sizeDistributions
{
    defineTypeNameAndDebug(lognormal, 0);
    addToRunTimeSelectionTable(sizeDistribution, lognormal, dictionary);
}
}


Foam::sizeDistributions::lognormal::lognormal(const dictionary& dict)
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "median", "logDeviation", "minRadius", "maxRadius"}
    );
    const scalar median = dictionaryInput::getPositive(dict, "median", dimLength);
    const scalar logDeviation =
        dictionaryInput::getPositive(dict, "logDeviation", dimless);
    const scalar minRadius =
        dictionaryInput::getPositive(dict, "minRadius", dimLength);
    const scalar maxRadius =
        dictionaryInput::getScalar(dict, "maxRadius", dimLength, minRadius);
    try
    {
        sizes_ = nscd::lognormalSize(median, logDeviation, minRadius, maxRadius);
    }
    catch (const std::invalid_argument& err)
    {
        dictionaryInput::badValue
        (
            dict, "maxRadius", Foam::name(maxRadius),
            "radii that hold part of the distribution; " + string(err.what())
        );
    }
}


nscd::SizeDistribution Foam::sizeDistributions::lognormal::sizes
(
    const label
) const
{
    return sizes_;
}
