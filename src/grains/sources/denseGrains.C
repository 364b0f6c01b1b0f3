/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "denseGrains.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "grainShapes.H"
#include "nscd/packing/DensePacking.hpp"
#include "readGeometry.H"

addToSelection(grainSource, grainSources, dense)

template<int D>
Foam::grainSources::dense<D>::dense
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
    dict_(dict),
    box_(readBox(dict, ctx.space)),
    solidFraction_
    (
        dictionaryInput::getScalar(dict, "solidFraction", dimless, 0, 1)
    ),
    distribution_
    (
        sizeDistribution::New(dictionaryInput::subDict(dict, "distribution"))
    ),
    material_(ctx.materials.index(dict, "material"))
{
    this->checkKeywords(dict, {"box", "solidFraction", "distribution"});

    for (int d = 0; d < D; ++d)
    {
        // Coordinates are written with a finite number of digits
        const scalar period = ctx.contact.period[d];
        periodic_[d] =
            mag(box_.upper[d] - box_.lower[d] - period) < 1e-6*period;
        if (periodic_[d])
        {
            box_.upper[d] = box_.lower[d] + period;
        }
    }
}


template<int D>
nscd::Grains<D> Foam::grainSources::dense<D>::read() const
{
    // Those around clusters, of which they fill a share, are packed
    constexpr scalar unit =
        constant::mathematical::pi*(D == 2 ? 1 : 4.0/3.0);
    const scalar share =
        this->shape_ < 0
      ? 1
      : this->context_.shapes.clusters()[this->shape_].volume/unit;
    const scalar packed = solidFraction_/share;

    string allowed("one that grains of this distribution reach in the box");
    if (share < 1)
    {
        const string around(string("the ") + grainSpace<D>::shape + "s around them");
        const scalar densest = D == 2 ? 0.84 : 0.64;
        allowed +=
            ", of these clusters at most about " + Foam::name(densest*share)
          + ": they fill " + Foam::name(share) + " of " + around
          + ", which are packed and reach about " + Foam::name(densest);
    }

    try
    {
        const nscd::SizeDistribution sizes(distribution_->sizes(D));
        const scalar median = sizes(0.5);
        this->announce
        (
            dict_, "distribution",
            packed*box_.volume()
           /(D == 2 ? 3.14*sqr(median) : 4.19*pow3(median))
        );
        const std::vector<double> radii = nscd::drawRadii<D>
        (
            sizes, box_, packed, this->seed_
        );
        return this->grains
        (
            nscd::densePacking<D>(box_, radii, this->seed_, periodic_),
            radii,
            material_
        );
    }
    catch (const std::exception& err)
    {
        dictionaryInput::badValue
        (
            dict_, "solidFraction", Foam::name(solidFraction_),
            allowed + "; " + string(err.what())
        );
    }
    return nscd::Grains<D>();
}
