/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BiotNumbers.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"
#include "functionOfTemperature.H"
#include "heatLaw.H"

#include <numeric>

template<int D>
Foam::scalar Foam::meanTemperature(const nscd::Grains<D>& grains)
{
    const auto& T = grains.temperature;
    return T.empty() ? 0 : std::accumulate(T.begin(), T.end(), 0.0)/T.size();
}


template<int D>
void Foam::printBiotNumbers
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const UList<settling>& alone,
    const dictionary& transport,
    const scalar mu
)
{
    const autoPtr<heatLaw> law
    (
        heatLaw::New
        (
            dictionaryInput::subDict(properties.coupling(), "heatTransfer"), D
        )
    );
    const scalar T = meanTemperature(grains);
    const scalar Cp =
        functionOfTemperature(transport, "Cp", dimHeatCapacity).at(T);
    const scalar k =
        functionOfTemperature(transport, "kappa", dimConductivity).at(T);
    const dictionary& materials = properties.dict().subDict("materials");

    scalar largest = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const label materiali = grains.material[i];
        const word& name = properties.materials().names()[materiali];
        const dictionary& material = materials.subDict(name);
        if (!material.found("conductivity"))
        {
            Info<< nl << "Biot number             unknown: '" << name
                << "' has no conductivity" << endl;
            return;
        }
        const scalar kp = dictionaryInput::getPositive
        (
            material, "conductivity", dimConductivity
        );
        const scalar d = alone[i].lawDiameter;
        const scalar Nu = law->Nu(1, alone[i].Re, mu*Cp/k);
        const scalar surface = law->perVolume(1, 1, d)*sqr(d);
        largest = max(largest, Nu*k/(kp*surface));
    }

    Info<< nl << "Biot number             " << largest
        << " at most, of grains that settle alone" << endl;
    if (largest > 0.1)
    {
        WarningInFunction
            << "Above 0.1 the inside of a grain lags behind its surface: one"
            << " temperature is not enough" << endl;
    }
}


template Foam::scalar Foam::meanTemperature(const nscd::Grains<2>&);
template Foam::scalar Foam::meanTemperature(const nscd::Grains<3>&);
template void Foam::printBiotNumbers
(
    const grainProperties<2>&, const nscd::Grains<2>&,
    const UList<settling>&, const dictionary&, const scalar
);
template void Foam::printBiotNumbers
(
    const grainProperties<3>&, const nscd::Grains<3>&,
    const UList<settling>&, const dictionary&, const scalar
);
