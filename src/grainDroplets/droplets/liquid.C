/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquid.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"

namespace
{

using namespace Foam;

// [J/kg]
const dimensionSet dimLatentHeat(0, 2, -2, 0, 0);

const dictionary& checkedLiquid(const dictionary& dict)
{
    dictionaryInput::checkKeywords
    (
        dict,
        {
            "density", "latentHeat", "boilingTemperature", "mu", "kappa", "Cp",
            "film", "vapourDensity"
        }
    );
    return dict;
}

}


Foam::liquid::liquid(const dictionary& dict, const scalar fluidDensity)
:
    density(dictionaryInput::getPositive(checkedLiquid(dict), "density", dimDensity)),
    latentHeat(dictionaryInput::getPositive(dict, "latentHeat", dimLatentHeat)),
    boilingTemperature
    (
        dictionaryInput::getPositive(dict, "boilingTemperature", dimTemperature)
    ),
    mu(dictionaryInput::getPositive(dict, "mu", dimDynamicViscosity)),
    kappa(dictionaryInput::getPositive(dict, "kappa", dimConductivity)),
    Cp(dictionaryInput::getPositive(dict, "Cp", dimHeatCapacity)),
    film
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "film", dimConductivity, kappa
        )
    ),
    vapourDensity
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "vapourDensity", dimDensity, fluidDensity
        )
    )
{}
