/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSource.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "grainShapes.H"
#include "randomOrientation.H"
#include "selected.H"

namespace Foam
{
    makeSelectable(grainSource)
}


template<int D>
Foam::grainSource<D>::grainSource(const dictionary& dict, const context& ctx)
:
    context_(ctx),
    region_
    (
        dict.found("region")
      ? grainRegion<D>::New
        (
            dictionaryInput::subDict(dict, "region"), ctx.space
        )
      : autoPtr<grainRegion<D>>()
    ),
    shape_(ctx.shapes.index(dict)),
    seed_(dictionaryInput::getLabelOrDefault(dict, "seed", 1, 0)),
    temperature_
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "temperature", dimTemperature, 0
        )
    )
{}


template<int D>
Foam::autoPtr<Foam::grainSource<D>> Foam::grainSource<D>::New
(
    const dictionary& dict,
    const context& ctx
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict, ctx);
}


template<int D>
void Foam::grainSource<D>::checkKeywords(const dictionary& dict, wordList own)
{
    own.append
    (
        wordList
        (
            {"type", "material", "shape", "seed", "temperature", "output", "order"}
        )
    );
    dictionaryInput::checkKeywords(dict, own);
}


template<int D>
void Foam::grainSource<D>::requireSome
(
    const dictionary& dict,
    const scalar radius,
    const nscd::Vectors<D>& centres
)
{
    if (centres.empty())
    {
        dictionaryInput::badValue
        (
            dict, "radius", Foam::name(radius),
            "a radius with which at least one grain fits into 'box', and into"
            " 'region' and between the grains of other sources"
        );
    }
}


template<int D>
bool Foam::grainSource<D>::accepts
(
    const nscd::Vector<D>& x,
    const scalar radius
) const
{
    // What would fill a region exactly is not lost to round-off
    const scalar r = (1 - 1e-9)*radius;
    return
        (!context_.isFree || context_.isFree(x, r))
     && (!region_ || region_->holds(x, r));
}


template<int D>
nscd::Vectors<D> Foam::grainSource<D>::accepted
(
    const nscd::Vectors<D>& centres,
    const scalar radius
) const
{
    nscd::Vectors<D> result;
    for (const nscd::Vector<D>& x : centres)
    {
        if (accepts(x, radius))
        {
            result.push_back(x);
        }
    }
    return result;
}


template<int D>
void Foam::grainSource<D>::announce
(
    const dictionary& dict,
    const word& keyword,
    const scalar number
)
{
    // Of half a kilobyte each
    constexpr scalar most = 1e8;

    Info<< "Source " << dict.dictName() << ": about " << std::round(number)
        << " grains" << endl;
    if (!(number <= most))
    {
        dictionaryInput::badValue
        (
            dict, keyword, dictionaryInput::written(dict, keyword),
            "one with which at most 1e8 grains are made"
        );
    }
}


template<int D>
nscd::Grains<D> Foam::grainSource<D>::grains
(
    const nscd::Vectors<D>& centres,
    const std::vector<double>& radii,
    const label material
) const
{
    nscd::Grains<D> g;
    g.resize(centres.size());
    g.position = centres;
    g.radius = radii;
    g.clusters = context_.shapes.clusters();

    nscd::Random random(seed_);
    for (std::size_t i = 0; i < g.size(); ++i)
    {
        g.id[i] = i;
        g.material[i] = material;
        g.temperature[i] = temperature_;
        g.shape[i] = shape_;
        if (shape_ >= 0)
        {
            g.orientation[i] = randomOrientation<D>(random);
        }
        g.mass[i] =
            context_.materials.density(material)*context_.space.volume(g, i);
    }
    return g;
}


template class Foam::grainSource<2>;
template class Foam::grainSource<3>;
