/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sieveSize.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "Tuple2.H"

namespace Foam
{
namespace sizeDistributions
{
    defineTypeNameAndDebug(sieve, 0);
    addToRunTimeSelectionTable(sizeDistribution, sieve, dictionary);
}
}


Foam::sizeDistributions::sieve::sieve(const dictionary& dict)
{
    dictionaryInput::checkKeywords(dict, {"type", "by", "passing"});

    curve_ =
        dictionaryInput::getWord(dict, "by", {"mass", "number"}) == "mass"
      ? nscd::SieveCurve::byMass
      : nscd::SieveCurve::byNumber;

    const string allowed("radii > 0 and fractions that rise from 0 to 1");
    const auto passing = dictionaryInput::getAs<List<Tuple2<scalar, scalar>>>
    (
        dict, "passing", allowed + ", as ((1e-3 0) (2e-3 1))"
    );
    for (const auto& entry : passing)
    {
        radii_.push_back(entry.first());
        passing_.push_back(entry.second());
    }
    try
    {
        sizes(3);
    }
    catch (const std::invalid_argument& err)
    {
        dictionaryInput::badValue
        (
            dict, "passing", Foam::name(label(radii_.size())) + " entries",
            allowed + "; " + string(err.what())
        );
    }
}


nscd::SizeDistribution Foam::sizeDistributions::sieve::sizes
(
    const label dimensions
) const
{
    return
        dimensions == 2
      ? nscd::tabulatedSize<2>(radii_, passing_, curve_)
      : nscd::tabulatedSize<3>(radii_, passing_, curve_);
}
