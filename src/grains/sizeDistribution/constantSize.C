/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "constantSize.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace sizeDistributions
{
    defineTypeNameAndDebug(constant, 0);
    addToRunTimeSelectionTable(sizeDistribution, constant, dictionary);
}
}


Foam::sizeDistributions::constant::constant(const dictionary& dict)
:
    radius_(dictionaryInput::getPositive(dict, "radius", dimLength))
{
    dictionaryInput::checkKeywords(dict, {"type", "radius"});
}


nscd::SizeDistribution Foam::sizeDistributions::constant::sizes
(
    const label
) const
{
    return nscd::constantSize(radius_);
}
