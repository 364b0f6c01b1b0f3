/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainInjection.H"

#include "dictionaryInput.H"
#include "functionEntries.H"
#include "nscd/shape/Append.hpp"
#include "randomOrientation.H"
#include "selected.H"
#include "sizeDistribution.H"

namespace Foam
{
    makeSelectable(grainInjection)
}


template<int D>
Foam::autoPtr<Foam::grainInjection<D>> Foam::grainInjection<D>::New
(
    const dictionary& dict,
    const grainProperties<D>& properties
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict, properties);
}


template<int D>
nscd::SizeDistribution Foam::grainInjection<D>::readSizes
(
    const dictionary& dict
)
{
    return
        sizeDistribution::New
        (
            dictionaryInput::subDict(dict, "distribution")
        )->sizes(D);
}


template<int D>
nscd::Vector<D> Foam::grainInjection<D>::readVelocity
(
    const dictionary& dict
) const
{
    if (!dict.found("velocity"))
    {
        return nscd::Vector<D>::Zero();
    }
    const string allowed
    (
        D == 2 ? "a vector in the plane of the mesh" : "a vector, as (0 0 1)"
    );
    const vector v(dictionaryInput::getAs<vector>(dict, "velocity", allowed));
    if (!properties_.space().holds(v) || cmptMax(cmptMag(v)) > 1e15)
    {
        OStringStream value;
        value << v;
        dictionaryInput::badValue(dict, "velocity", value.str(), allowed);
    }
    return properties_.space().fromSpace(v);
}


template<int D>
Foam::grainInjection<D>::grainInjection
(
    const dictionary& dict,
    const grainProperties<D>& properties
)
:
    properties_(properties),
    material_(properties.materials().index(dict, "material")),
    shape_(properties.shapes().index(dict)),
    sizes_(readSizes(dict)),
    hasVelocity_(dict.found("velocity")),
    velocity_(readVelocity(dict)),
    temperature_
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "temperature", dimTemperature, 0
        )
    ),
    rate_(dict, properties.space().mesh().time().value()),
    random_(dictionaryInput::getLabelOrDefault(dict, "seed", 1, 0)),
    number_(0)
{
    drawRadius();
}


template<int D>
void Foam::grainInjection<D>::checkKeywords
(
    const dictionary& dict,
    wordList own
)
{
    own.append
    (
        dictionaryInput::functionKeywords(dict, injectionRate::keywords)
    );
    own.append
    (
        wordList
        (
            {
                "type", "material", "shape", "distribution", "velocity",
                "temperature", "seed"
            }
        )
    );
    dictionaryInput::checkKeywords(dict, own);
}


template<int D>
nscd::Grains<D> Foam::grainInjection<D>::next() const
{
    nscd::Grains<D> grain;
    grain.resize(1);
    grain.clusters = properties_.shapes().clusters();
    grain.radius[0] = radius_;
    grain.shape[0] = shape_;
    grain.material[0] = material_;
    grain.temperature[0] = temperature_;
    grain.velocity[0] = velocity_;
    grain.mass[0] =
        properties_.materials().density(material_)*properties_.packingRatio()
       *properties_.space().volume(grain, 0);
    return grain;
}


template<int D>
Foam::grainTally Foam::grainInjection<D>::tally
(
    const nscd::Grains<D>& grain
) const
{
    grainTally result;
    result.number = 1;
    result.mass = grain.mass[0];
    result.volume = grain.mass[0]/properties_.materials().density(material_);
    result.momentum =
        grain.mass[0]*properties_.space().toSpace(grain.velocity[0]);
    return result;
}


template<int D>
Foam::grainTally Foam::grainInjection<D>::inject
(
    const scalar now,
    const nscd::Grains<D>& grains,
    const nscd::WallContact<D>& walls,
    const bool withFluid,
    const lookup& at,
    nscd::Grains<D>& more
)
{
    constexpr label maxTries = 100;

    grainTally all;
    const scalar due = rate_.owe(now);
    nscd::Grains<D> grain(next());
    rate_.requireFew(due, tally(grain));
    if (!rate_.owes(tally(grain)))
    {
        return all;
    }

    const std::array<double, 3>& period = properties_.contact().period;
    grainRoom<D> room(grains, walls, period, region(), largest());
    for (std::size_t i = 0; i < more.size(); ++i)
    {
        room.take(more.position[i], more.radius[i]);
    }

    for (label tries = 0; tries < maxTries && rate_.owes(tally(grain)); ++tries)
    {
        nscd::Vector<D>& x = grain.position[0];
        if
        (
            !draw(random_, radius_, withFluid, x)
         || !room.isFree(x, radius_)
        )
        {
            continue;
        }
        if (isInMesh() || !hasVelocity_)
        {
            const surroundings here(at(x));
            if (isInMesh() && !here.isInMesh)
            {
                continue;
            }
            if (!hasVelocity_)
            {
                grain.velocity[0] =
                    properties_.space().fromSpace(here.velocity);
            }
        }
        if (shape_ >= 0)
        {
            grain.orientation[0] = randomOrientation<D>(random_);
        }
        room.take(x, radius_);
        nscd::append(more, grain);
        all += tally(grain);
        rate_.pay(tally(grain));
        ++number_;

        drawRadius();
        grain = next();
        tries = -1;
    }
    return all;
}


template<int D>
Foam::dictionary Foam::grainInjection<D>::state() const
{
    dictionary state;
    state.add("number", number_);
    state.add("radius", radius_);
    state.add("drawn", scalar(random_.drawn()));
    rate_.write(state);
    return state;
}


template<int D>
void Foam::grainInjection<D>::setState(const dictionary& state)
{
    number_ = state.get<label>("number");
    radius_ = state.get<scalar>("radius");
    const auto drawn = std::uint64_t(state.get<scalar>("drawn"));
    random_.skip(drawn - min(drawn, random_.drawn()));
    rate_.read(state);
}


template class Foam::grainInjection<2>;
template class Foam::grainInjection<3>;
