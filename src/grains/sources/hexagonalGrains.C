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
    this->checkKeywords(dict, {"box", "radius", "gap"});

    const scalar gap =
        dictionaryInput::getScalarOrDefault(dict, "gap", dimLength, 0, 0);

    centres_ = nscd::hexagonal<D>(readBox(dict, ctx.space), radius_, gap);
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
