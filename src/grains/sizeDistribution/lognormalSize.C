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
    sizes_ = cutOff
    (
        dict,
        [=](scalar minRadius, scalar maxRadius)
        {
            return nscd::lognormalSize(median, logDeviation, minRadius, maxRadius);
        }
    );
}


nscd::SizeDistribution Foam::sizeDistributions::lognormal::sizes
(
    const label
) const
{
    return sizes_;
}
