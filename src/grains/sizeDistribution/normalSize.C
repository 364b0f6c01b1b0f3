/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "normalSize.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace sizeDistributions
{
    defineTypeNameAndDebug(normal, 0);
    addToRunTimeSelectionTable(sizeDistribution, normal, dictionary);
}
}


Foam::sizeDistributions::normal::normal(const dictionary& dict)
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "mean", "standardDeviation", "minRadius", "maxRadius"}
    );
    const scalar mean = dictionaryInput::getPositive(dict, "mean", dimLength);
    const scalar standardDeviation =
        dictionaryInput::getPositive(dict, "standardDeviation", dimLength);
    sizes_ = cutOff
    (
        dict,
        [=](scalar minRadius, scalar maxRadius)
        {
            return nscd::normalSize(mean, standardDeviation, minRadius, maxRadius);
        }
    );
}


nscd::SizeDistribution Foam::sizeDistributions::normal::sizes
(
    const label
) const
{
    return sizes_;
}
