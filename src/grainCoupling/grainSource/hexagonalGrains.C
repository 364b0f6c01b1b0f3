/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hexagonalGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/Packing.hpp"
#include "planarMesh.H"

namespace Foam
{
namespace grainSources
{
    defineTypeNameAndDebug(hexagonal, 0);
    addToRunTimeSelectionTable(grainSource, hexagonal, dictionary);
}
}


Foam::grainSources::hexagonal::hexagonal
(
    const dictionary& dict,
    const context& ctx
)
:
    grainSource(ctx),
    radius_(dictionaryInput::getPositive(dict, "radius", dimLength)),
    material_(ctx.materials.index(dict, "material"))
{
    checkKeywords(dict, {"box", "radius", "gap"});

    const scalar gap =
        dictionaryInput::getScalarOrDefault(dict, "gap", dimLength, 0, 0);

    centres_ = nscd::hexagonal<2>(box(dict), radius_, gap);
    requireSome(dict, radius_, centres_);
}


nscd::Grains<2> Foam::grainSources::hexagonal::read() const
{
    return grains
    (
        centres_, std::vector<double>(centres_.size(), radius_), material_
    );
}
