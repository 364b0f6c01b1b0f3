/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexagonalGrains.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/packing/Packing.hpp"
#include "readGeometry.H"

addToSelection(grainSource, grainSources, hexagonal)

template<int D>
Foam::grainSources::hexagonal<D>::hexagonal
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
    radius_(dictionaryInput::getPositive(dict, "radius", dimLength)),
    material_(ctx.materials.index(dict, "material"))
{
    this->checkKeywords(dict, {"box", "radius", "gap", "region"});

    const scalar gap =
        dictionaryInput::getScalarOrDefault(dict, "gap", dimLength, 0, 0);

    // In the densest lattice a grain has this share of its spacing's cube
    const scalar share = D == 2 ? std::sqrt(0.75) : std::sqrt(0.5);
    const nscd::Box<D> box(readBox(dict, ctx.space));
    this->announce
    (
        dict, "radius", box.volume()/(share*std::pow(2*radius_ + gap, D))
    );
    centres_ = this->accepted(nscd::hexagonal<D>(box, radius_, gap), radius_);
    this->requireSome(dict, radius_, centres_);
}


template<int D>
nscd::Grains<D> Foam::grainSources::hexagonal<D>::read() const
{
    return this->grains
    (
        centres_, std::vector<double>(centres_.size(), radius_), material_
    );
}
