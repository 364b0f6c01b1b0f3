/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomFillGrains.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/packing/Packing.hpp"
#include "nscd/base/Random.hpp"
#include "readGeometry.H"

addToSelection(grainSource, grainSources, randomFill)

template<int D>
Foam::grainSources::randomFill<D>::randomFill
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
    dict_(dict),
    box_(readBox(dict, ctx.space)),
    number_(dictionaryInput::getLabel(dict, "number", 0)),
    minRadius_(dictionaryInput::getPositive(dict, "minRadius", dimLength)),
    maxRadius_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict, "maxRadius", dimLength, minRadius_, minRadius_
        )
    ),
    material_(ctx.materials.index(dict, "material"))
{
    this->checkKeywords(dict, {"box", "number", "minRadius", "maxRadius", "region"});
}


template<int D>
nscd::Grains<D> Foam::grainSources::randomFill<D>::read() const
{
    this->announce(dict_, "number", number_);
    nscd::Random random(this->seed_);
    std::vector<double> radii;
    for (label i = 0; i < number_; ++i)
    {
        radii.push_back(random.uniform(minRadius_, maxRadius_));
    }
    try
    {
        return this->grains
        (
            nscd::randomFill<D>
            (
                box_, radii, this->seed_, 10000,
                [&](const nscd::Vector<D>& x, const double radius)
                {
                    return this->accepts(x, radius);
                }
            ),
            radii,
            material_
        );
    }
    catch (const std::exception& err)
    {
        dictionaryInput::badValue
        (
            dict_, "number", Foam::name(number_),
            "as many grains as find room in the box; "
          + string(err.what())
        );
    }
    return nscd::Grains<D>();
}
