/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomFillGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/Packing.hpp"
#include "planarMesh.H"

#include <random>

namespace Foam
{
namespace grainSources
{
    defineTypeNameAndDebug(randomFill, 0);
    addToRunTimeSelectionTable(grainSource, randomFill, dictionary);
}
}


Foam::grainSources::randomFill::randomFill
(
    const dictionary& dict,
    const context& ctx
)
:
    grainSource(ctx),
    box_(box(dict)),
    number_(dictionaryInput::getLabel(dict, "number", 0)),
    minRadius_(dictionaryInput::getPositive(dict, "minRadius", dimLength)),
    maxRadius_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict, "maxRadius", dimLength, minRadius_, minRadius_
        )
    ),
    seed_(dictionaryInput::getLabelOrDefault(dict, "seed", 1, 0)),
    material_(ctx.materials.index(dict, "material"))
{
    checkKeywords(dict, {"box", "number", "minRadius", "maxRadius", "seed"});
}


nscd::Grains<2> Foam::grainSources::randomFill::read() const
{
    // The engine's numbers are the same everywhere, those of the standard
    // distributions are not
    std::mt19937_64 engine(seed_);
    std::vector<double> radii;
    for (label i = 0; i < number_; ++i)
    {
        const double unit = double(engine() >> 11)*0x1p-53;
        radii.push_back(minRadius_ + (maxRadius_ - minRadius_)*unit);
    }
    return grains
    (
        nscd::randomFill<2>(box_, radii, seed_), radii, material_
    );
}
