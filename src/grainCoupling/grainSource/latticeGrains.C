/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/Packing.hpp"
#include "planarMesh.H"

namespace Foam
{
namespace grainSources
{
    defineTypeNameAndDebug(lattice, 0);
    addToRunTimeSelectionTable(grainSource, lattice, dictionary);
}
}


Foam::grainSources::lattice::lattice
(
    const dictionary& dict,
    const context& ctx
)
:
    grainSource(ctx),
    radius_(dictionaryInput::getPositive(dict, "radius", dimLength)),
    material_(ctx.materials.index(dict, "material"))
{
    checkKeywords(dict, {"box", "radius", "spacing"});

    const scalar spacing = dictionaryInput::getScalarOrDefault
    (
        dict, "spacing", dimLength, 2*radius_, 2*radius_
    );
    centres_ = nscd::lattice<2>(box(dict), radius_, spacing);
    requireSome(dict, radius_, centres_);
}


nscd::Grains<2> Foam::grainSources::lattice::read() const
{
    return grains
    (
        centres_, std::vector<double>(centres_.size(), radius_), material_
    );
}
