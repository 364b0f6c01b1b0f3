/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeGrains.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/packing/Packing.hpp"
#include "readGeometry.H"

addToSelection(grainSource, grainSources, lattice)

template<int D>
Foam::grainSources::lattice<D>::lattice
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
    radius_(dictionaryInput::getPositive(dict, "radius", dimLength)),
    material_(ctx.materials.index(dict, "material"))
{
    this->checkKeywords(dict, {"box", "radius", "spacing", "region"});

    const scalar spacing = dictionaryInput::getScalarOrDefault
    (
        dict, "spacing", dimLength, 2*radius_, 2*radius_
    );
    const nscd::Box<D> box(readBox(dict, ctx.space));
    this->announce(dict, "radius", box.volume()/std::pow(spacing, D));
    centres_ =
        this->accepted(nscd::lattice<D>(box, radius_, spacing), radius_);
    this->requireSome(dict, radius_, centres_);
}


template<int D>
nscd::Grains<D> Foam::grainSources::lattice<D>::read() const
{
    return this->grains
    (
        centres_, std::vector<double>(centres_.size(), radius_), material_
    );
}
