/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSource.H"

#include "grainMaterials.H"
#include "mathematicalConstants.H"
#include "planarMesh.H"
#include "selected.H"

namespace Foam
{
    defineTypeNameAndDebug(grainSource, 0);
    defineRunTimeSelectionTable(grainSource, dictionary);
}


Foam::autoPtr<Foam::grainSource> Foam::grainSource::New
(
    const dictionary& dict,
    const context& ctx
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict, "source of grains"
    )(dict, ctx);
}


nscd::Grains<2> Foam::grainSource::grains
(
    const nscd::Vectors<2>& centres,
    const std::vector<double>& radii,
    const label material
) const
{
    nscd::Grains<2> g;
    g.resize(centres.size());
    g.position = centres;
    g.radius = radii;

    for (std::size_t i = 0; i < g.size(); ++i)
    {
        g.id[i] = i;
        g.material[i] = material;
        g.mass[i] =
            context_.materials.density(material)*context_.plane.depth()
           *constant::mathematical::pi*sqr(radii[i]);
    }
    return g;
}
