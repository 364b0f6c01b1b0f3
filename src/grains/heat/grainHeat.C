/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainHeat.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"
#include "HashTable.H"

namespace
{

using namespace Foam;

template<int D>
constexpr const char* defaultLaw = D == 2 ? "strip" : "spheres";

//- Null for none
template<int D>
nscd::ConductanceLaw law(const dictionary& dict)
{
    dictionaryInput::checkKeywords
    (
        dict, {"conductance", "inside", "radiation", "throughFluid"}
    );

    namespace laws = nscd::conductance;
    const HashTable<nscd::ConductanceLaw> known
    (
        D == 2
      ? HashTable<nscd::ConductanceLaw>
        {
            {"none", nullptr},
            {"rowOfSpheres", laws::rowOfSpheres},
            {"spot", laws::spot},
            {"squarePatch", laws::squarePatch},
            {"strip", laws::strip}
        }
      : HashTable<nscd::ConductanceLaw>
        {
            {"none", nullptr},
            {"spheres", laws::spheres}
        }
    );
    return known
    [
        dictionaryInput::getWordOrDefault
        (
            dict, "conductance", defaultLaw<D>, known.sortedToc()
        )
    ];
}

}


template<int D>
std::unique_ptr<Foam::grainHeat<D>> Foam::grainHeat<D>::New
(
    const dictionary& properties,
    const grainSpace<D>& space,
    const grainMaterials& materials,
    const grainWalls<D>& walls
)
{
    if (properties.found("heat"))
    {
        return std::make_unique<grainHeat>(properties, space, materials, walls);
    }
    if (walls.heatedNames().size())
    {
        dictionaryInput::badValue
        (
            properties.subDict("walls").subDict(walls.heatedNames().first()),
            "temperature", Foam::name(walls.temperatures().first()),
            "no temperature, or a dictionary 'heat' besides 'walls'"
        );
    }
    return nullptr;
}


template<int D>
Foam::grainHeat<D>::grainHeat
(
    const dictionary& properties,
    const grainSpace<D>& space,
    const grainMaterials& materials,
    const grainWalls<D>& walls
)
:
    properties_(properties),
    materials_(materials),
    walls_(walls),
    conduction_(newConduction(space.depth())),
    near_(properties, space, materials, walls),
    conductInside_
    (
        dictionaryInput::getWordOrDefault
        (
            properties.subDict("heat"), "inside", "isothermal",
            {"conducting", "isothermal"}
        ) == "conducting"
    ),
    heatCapacity_(materials.names().size(), Zero),
    conductivity_(materials.names().size(), Zero),
    wallHeat_(walls.heatedNames().size(), Zero)
{
    forAll(heatCapacity_, i)
    {
        heatCapacity_[i] = dictionaryInput::getPositiveOrDefault
        (
            ofMaterial(i), "heatCapacity", dimHeatCapacity, 0
        );
        conductivity_[i] = dictionaryInput::getPositiveOrDefault
        (
            ofMaterial(i), "conductivity", dimConductivity, 0
        );
    }
    readWalls();
}


template<int D>
const Foam::dictionary& Foam::grainHeat<D>::ofMaterial(const label i) const
{
    return properties_.subDict("materials").subDict(materials_.names()[i]);
}


template<int D>
std::vector<nscd::ThermalMaterial> Foam::grainHeat<D>::thermalMaterials() const
{
    std::vector<nscd::ThermalMaterial> result;
    forAll(materials_.names(), i)
    {
        const dictionary& dict = ofMaterial(i);
        result.push_back
        ({
            dictionaryInput::getPositive(dict, "conductivity", dimConductivity),
            dictionaryInput::getPositive(dict, "youngsModulus", dimPressure),
            dictionaryInput::getScalarOrDefault
            (
                dict, "poissonRatio", dimless, 0.3, 0, 0.5
            ),
            dictionaryInput::getPositive(dict, "density", dimDensity)
           *dictionaryInput::getPositiveOrDefault
            (
                dict, "heatCapacity", dimHeatCapacity, 0
            )
        });
    }
    return result;
}


template<int D>
std::unique_ptr<const nscd::Conduction<D>>
Foam::grainHeat<D>::newConduction(const scalar depth) const
{
    const nscd::ConductanceLaw conductance
    (
        law<D>(dictionaryInput::subDict(properties_, "heat"))
    );
    return
        conductance
      ? std::make_unique<const nscd::Conduction<D>>
        (
            thermalMaterials(), depth, conductance
        )
      : nullptr;
}


template<int D>
void Foam::grainHeat<D>::readWalls()
{
    forAll(walls_.heated(), i)
    {
        nscd::ThermalWall wall{nscd::materialOf(walls_.walls()[i]), {}};
        if (walls_.heated()[i] >= 0)
        {
            if (!conductThroughContacts())
            {
                dictionaryInput::badValue
                (
                    properties_.subDict("heat"), "conductance", "none",
                    "a conductance, 'throughFluid' or 'radiation', as the wall '"
                  + walls_.heatedNames()[walls_.heated()[i]]
                  + "' has a temperature"
                );
            }
            wall.temperature = walls_.temperatures()[walls_.heated()[i]];
        }
        thermalWalls_.push_back(wall);
    }
}


template<int D>
void Foam::grainHeat<D>::check(const nscd::Grains<D>& grains) const
{
    near_.check(grains);
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (heatCapacity_[grains.material[i]] <= 0)
        {
            dictionaryInput::badValue
            (
                ofMaterial(grains.material[i]), "heatCapacity", "none",
                "a value > 0 [J/kg/K], as there are grains of this material"
            );
        }
        if (!(grains.temperature[i] > 0))
        {
            FatalIOErrorInFunction(properties_)
                << "Keyword 'temperature': grain " << label(grains.id[i])
                << " has the value " << grains.temperature[i] << nl
                << "    allowed: with 'heat' a value > 0 [K], an entry of"
                << " 'initialGrains' or a column of its file; a state has the"
                << " temperatures that its grains began with"
                << exit(FatalIOError);
        }
    }
}


template<int D>
void Foam::grainHeat<D>::requireNoContacts() const
{
    if (hasConductance())
    {
        const dictionary& dict = properties_.subDict("heat");
        dictionaryInput::badValue
        (
            dict, "conductance",
            dict.getOrDefault<word>
            (
                "conductance", word(defaultLaw<D>) + ", the default,"
            )
          + " with 'motion fixed' in 'coupling', which leaves the forces of contacts unknown",
            "none, beside which 'throughFluid' conducts between fixed grains that"
            " are near; or 'motion free'"
        );
    }
}


template<int D>
std::vector<double> Foam::grainHeat<D>::capacities
(
    const nscd::Grains<D>& grains
) const
{
    std::vector<double> result(grains.size());
    for (std::size_t i = 0; i < result.size(); ++i)
    {
        result[i] = capacity(grains, i);
    }
    return result;
}


template<int D>
nscd::HeatNetwork Foam::grainHeat<D>::network
(
    const nscd::Grains<D>& grains,
    const std::vector<nscd::Touching<D>>& touching,
    const scalar deltaT,
    const std::vector<nscd::WallBody<D>>& bodies,
    const std::array<double, 3>& period
) const
{
    nscd::HeatNetwork result(capacities(grains));
    if (conduction_)
    {
        const nscd::HeatNetwork joined
        (
            conduction_->network
            (
                grains, capacities(grains), touching, thermalWalls_, deltaT
            )
        );
        for (const nscd::HeatNetwork::Link& link : joined.links())
        {
            result.join(link.i, link.j, link.conductance);
        }
        for (const nscd::HeatNetwork::Outlet& outlet : joined.outlets())
        {
            result.joinReservoir
            (
                outlet.i, walls_.heated()[outlet.reservoir],
                outlet.conductance, outlet.temperature
            );
        }
    }
    near_.join(result, grains, bodies, period);
    return result;
}


template<int D>
std::vector<double> Foam::grainHeat<D>::advance
(
    const nscd::Grains<D>& grains,
    const std::vector<nscd::Touching<D>>& touching,
    const scalar deltaT,
    const std::vector<nscd::WallBody<D>>& bodies,
    const std::array<double, 3>& period
)
{
    std::vector<double> temperature(grains.temperature);
    if (conductThroughContacts())
    {
        std::vector<double> given(wallHeat_.size(), 0.0);
        network(grains, touching, deltaT, bodies, period)
       .advance(temperature, given, deltaT);
        wallHeat_ = scalarList(given.begin(), given.end());
    }
    return temperature;
}


template class Foam::grainHeat<2>;
template class Foam::grainHeat<3>;
