/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"

#include "selected.H"

namespace Foam
{
    defineTypeNameAndDebug(sizeDistribution, 0);
    defineRunTimeSelectionTable(sizeDistribution, dictionary);
}


Foam::autoPtr<Foam::sizeDistribution> Foam::sizeDistribution::New
(
    const dictionary& dict
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict, "distribution of sizes"
    )(dict);
}
