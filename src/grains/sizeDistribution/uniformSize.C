/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "uniformSize.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace sizeDistributions
{
    defineTypeNameAndDebug(uniform, 0);
    addToRunTimeSelectionTable(sizeDistribution, uniform, dictionary);
}
}


Foam::sizeDistributions::uniform::uniform(const dictionary& dict)
:
    minRadius_(dictionaryInput::getPositive(dict, "minRadius", dimLength)),
    maxRadius_
    (
        dictionaryInput::getScalar(dict, "maxRadius", dimLength, minRadius_)
    )
{
    dictionaryInput::checkKeywords(dict, {"type", "minRadius", "maxRadius"});
}


nscd::SizeDistribution Foam::sizeDistributions::uniform::sizes
(
    const label
) const
{
    return nscd::uniformSize(minRadius_, maxRadius_);
}
