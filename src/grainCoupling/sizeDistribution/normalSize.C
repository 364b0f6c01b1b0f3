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
    const scalar minRadius =
        dictionaryInput::getPositive(dict, "minRadius", dimLength);
    const scalar maxRadius =
        dictionaryInput::getScalar(dict, "maxRadius", dimLength, minRadius);
    try
    {
        sizes_ = nscd::normalSize(mean, standardDeviation, minRadius, maxRadius);
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


nscd::SizeDistribution Foam::sizeDistributions::normal::sizes
(
    const label
) const
{
    return sizes_;
}
