/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"

#include "dictionaryInput.H"
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
        *dictionaryConstructorTablePtr_, dict
    )(dict);
}


nscd::SizeDistribution Foam::sizeDistribution::cutOff
(
    const dictionary& dict,
    const std::function<nscd::SizeDistribution(scalar, scalar)>& make
)
{
    const scalar minRadius =
        dictionaryInput::getPositive(dict, "minRadius", dimLength);
    const scalar maxRadius =
        dictionaryInput::getScalar(dict, "maxRadius", dimLength, minRadius);
    try
    {
        return make(minRadius, maxRadius);
    }
    catch (const std::invalid_argument& err)
    {
        dictionaryInput::badValue
        (
            dict, "maxRadius", Foam::name(maxRadius),
            "radii that hold part of the distribution; " + string(err.what())
        );
    }
    return nscd::SizeDistribution();
}
