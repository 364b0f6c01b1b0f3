/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearHeat.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"
#include "HashTable.H"
#include "mathematicalConstants.H"

namespace
{

using namespace Foam;

//- Sub-dictionary of 'heat', or an empty one
dictionary optional(const dictionary& properties, const word& name)
{
    const dictionary& heat = dictionaryInput::subDict(properties, "heat");
    return
        heat.found(name) ? dictionaryInput::subDict(heat, name) : dictionary();
}


//- Null for none
template<int D, class Law>
Law selected
(
    const dictionary& dict,
    const Law& spheres,
    const Law& cylinders,
    const Law& rowOfSpheres
)
{
    if (dict.empty())
    {
        return nullptr;
    }
    const HashTable<Law> known
    (
        D == 3
      ? HashTable<Law>{{"spheres", spheres}}
      : HashTable<Law>
        {
            {"cylinders", cylinders},
            {"rowOfSpheres", rowOfSpheres}
        }
    );
    return known[dictionaryInput::getWord(dict, "type", known.sortedToc())];
}

}


template<int D>
Foam::nearHeat<D>::nearHeat
(
    const dictionary& properties,
    const grainSpace<D>& space,
    const grainMaterials& materials,
    const grainWalls<D>& walls
)
:
    heat_(dictionaryInput::subDict(properties, "heat")),
    walls_(walls),
    depth_(space.depth()),
    gap_
    (
        selected<D, nscd::GapLaw>
        (
            optional(properties, "throughFluid"),
            nscd::gap::spheres, nscd::gap::cylinders, nscd::gap::rowOfSpheres
        )
    ),
    sight_
    (
        selected<D, nscd::SightLaw>
        (
            optional(properties, "radiation"),
            nscd::sight::spheres, nscd::sight::cylinders,
            nscd::sight::rowOfSpheres
        )
    ),
    conductivity_(0),
    lens_(0),
    leastGap_(0),
    range_(1),
    emissivity_(materials.names().size(), Zero)
{
    if (gap_)
    {
        const dictionary& dict =
            properties.subDict("heat").subDict("throughFluid");
        dictionaryInput::checkKeywords
        (
            dict, {"type", "conductivity", "lens", "leastGap"}
        );
        conductivity_ =
            dictionaryInput::getPositive(dict, "conductivity", dimConductivity);
        lens_ = dictionaryInput::getScalarOrDefault
        (
            dict, "lens", dimless, 0.2, 0, 1
        );
        leastGap_ = dictionaryInput::getPositiveOrDefault
        (
            dict, "leastGap", dimLength, 2.75e-8
        );
    }
    if (sight_)
    {
        const dictionary& dict =
            properties.subDict("heat").subDict("radiation");
        dictionaryInput::checkKeywords(dict, {"type", "range"});
        range_ = dictionaryInput::getScalarOrDefault
        (
            dict, "range", dimless, 1.5, 1, 5
        );
        forAll(emissivity_, i)
        {
            const dictionary& material =
                properties.subDict("materials").subDict(materials.names()[i]);
            emissivity_[i] =
                dictionaryInput::getPositive(material, "emissivity", dimless);
            if (emissivity_[i] > 1)
            {
                dictionaryInput::badValue
                (
                    material, "emissivity", Foam::name(emissivity_[i]),
                    "values > 0, at most 1"
                );
            }
        }
    }
}


template<int D>
void Foam::nearHeat<D>::check(const nscd::Grains<D>& grains) const
{
    for (const int shape : grains.shape)
    {
        if (isActive() && shape >= 0)
        {
            const word keyword(gap_ ? "throughFluid" : "radiation");
            dictionaryInput::badValue
            (
                heat_, keyword, "with clusters", "none, as grains are clusters"
            );
        }
    }
}


template<int D>
template<class Law>
double Foam::nearHeat<D>::sum
(
    const nscd::Grains<D>& grains,
    const nscd::NearBodies& bodies,
    const Law& law
) const
{
    nscd::NearPair pair
    {
        grains.radius[bodies.first],
        bodies.second < 0
      ? std::numeric_limits<double>::infinity()
      : grains.radius[bodies.second],
        bodies.distance,
        depth_
    };
    return nscd::ofOwnPart(bodies.own, [&](const double beside)
    {
        pair.beside = beside;
        return law(pair);
    });
}


template<int D>
std::vector<double> Foam::nearHeat<D>::areas
(
    const nscd::Grains<D>& grains,
    const std::vector<nscd::NearBodies>& pairs
) const
{
    std::vector<double> result(pairs.size()), seen(grains.size(), 0.0);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const nscd::NearBodies& near = pairs[i];
        const double radius = grains.radius[near.first];
        const bool inRange =
            near.second < 0
         || near.distance < range_*(radius + grains.radius[near.second]);
        result[i] = inRange
          ? sum(grains, near, [&](const nscd::NearPair& pair)
            {
                return sight_(pair, 2*range_*radius);
            })
          : 0;
        for (const int grain : {near.first, near.second})
        {
            if (grain >= 0)
            {
                seen[grain] += result[i];
            }
        }
    }
    const auto excess = [&](const int grain)
    {
        if (grain < 0)
        {
            return 1.0;
        }
        // Of a row of spheres, of their number in it
        const double r = grains.radius[grain];
        const double all =
            D == 3 ? 4*constant::mathematical::pi*r*r
          : 2*constant::mathematical::pi*r*depth_;
        return std::max(1.0, seen[grain]/all);
    };
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        result[i] /=
            std::max(excess(pairs[i].first), excess(pairs[i].second));
    }
    return result;
}


template<int D>
void Foam::nearHeat<D>::join
(
    nscd::HeatNetwork& network,
    const nscd::Grains<D>& grains,
    const std::vector<nscd::WallBody<D>>& bodies,
    const std::array<double, 3>& period
) const
{
    if (!isActive())
    {
        return;
    }
    check(grains);
    if (!contact_)
    {
        contact_ =
            std::make_unique<nscd::WallContact<D>>(walls_.walls(), period);
    }
    contact_->place(walls_.bodies(), bodies);
    const std::vector<nscd::NearBodies> near
    (
        nscd::nearBodies<D>
        (
            grains, *contact_, std::max(range_, 1 + lens_), period
        )
    );
    const std::vector<double> area
    (
        sight_ ? areas(grains, near) : std::vector<double>()
    );
    for (std::size_t i = 0; i < near.size(); ++i)
    {
        const int first = near[i].first, second = near[i].second;
        const int wall = second < 0 ? walls_.heated()[~second] : -1;
        if ((second < 0 && wall < 0) || first == second)
        {
            continue;
        }
        const double other =
            second < 0 ? walls_.temperatures()[wall] : grains.temperature[second];
        const int material =
            second < 0
          ? nscd::materialOf(walls_.walls()[~second])
          : grains.material[second];

        double h = 0;
        if (gap_)
        {
            h += conductivity_*sum(grains, near[i], [&](const nscd::NearPair& pair)
            {
                return gap_(pair, lens_, leastGap_);
            });
        }
        if (sight_)
        {
            h +=
                area[i]
               *nscd::greyness
                (
                    emissivity_[grains.material[first]], emissivity_[material]
                )
               *nscd::radiationCoefficient(grains.temperature[first], other);
        }
        if (h > 0 && second < 0)
        {
            network.joinReservoir(first, wall, h, other);
        }
        else if (h > 0)
        {
            network.join(first, second, h);
        }
    }
}


template class Foam::nearHeat<2>;
template class Foam::nearHeat<3>;
