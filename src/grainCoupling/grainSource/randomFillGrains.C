/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomFillGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/Packing.hpp"
#include "nscd/Random.hpp"
#include "planarMesh.H"

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
    dict_(dict),
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
    nscd::Random random(seed_);
    std::vector<double> radii;
    for (label i = 0; i < number_; ++i)
    {
        radii.push_back(random.uniform(minRadius_, maxRadius_));
    }
    try
    {
        return grains
        (
            nscd::randomFill<2>(box_, radii, seed_), radii, material_
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
    return nscd::Grains<2>();
}
