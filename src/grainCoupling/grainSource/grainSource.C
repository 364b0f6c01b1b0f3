/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSource.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "mathematicalConstants.H"
#include "OStringStream.H"
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


void Foam::grainSource::checkKeywords(const dictionary& dict, wordList own)
{
    own.append(wordList({"type", "material", "output"}));
    dictionaryInput::checkKeywords(dict, own);
}


void Foam::grainSource::requireSome
(
    const dictionary& dict,
    const scalar radius,
    const nscd::Vectors<2>& centres
)
{
    if (centres.empty())
    {
        dictionaryInput::badValue
        (
            dict, "radius", Foam::name(radius),
            "a radius with which at least one grain fits into 'box'"
        );
    }
}


nscd::Box<2> Foam::grainSource::box(const dictionary& dict) const
{
    const string allowed
    (
        "two corners of a box in the plane of the mesh, as (0 0 0) (1 1 0)"
    );
    ITstream& is = dict.lookup("box");

    // Two vectors of three numbers, with their brackets
    if (is.size() != 10)
    {
        OStringStream value;
        for (const token& t : static_cast<const tokenList&>(is))
        {
            value << t << ' ';
        }
        dictionaryInput::badValue(dict, "box", value.str(), allowed);
    }
    const point first(is), second(is);
    const planarMesh::point2 a(context_.plane.toPlane(first));
    const planarMesh::point2 b(context_.plane.toPlane(second));
    const nscd::Box<2> result{a.cwiseMin(b), a.cwiseMax(b)};

    if ((result.upper - result.lower).minCoeff() <= 0)
    {
        OStringStream value;
        value << first << ' ' << second;
        dictionaryInput::badValue(dict, "box", value.str(), allowed);
    }
    return result;
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
