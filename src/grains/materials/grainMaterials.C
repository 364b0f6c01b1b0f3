/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainMaterials.H"

#include "contactLaw.H"
#include "dictionaryInput.H"
#include "Pair.H"

Foam::grainMaterials::grainMaterials(const dictionary& dict)
:
    dict_(dict)
{
    const dictionary& materials = dictionaryInput::subDict(dict, "materials");

    names_ = materials.toc();
    if (names_.empty())
    {
        FatalIOErrorInFunction(materials)
            << "Keyword 'materials' holds no material" << nl
            << "    allowed: one sub-dictionary per material"
            << exit(FatalIOError);
    }

    density_.resize(names_.size());
    forAll(names_, i)
    {
        const dictionary& material =
            dictionaryInput::subDict(materials, names_[i]);

        dictionaryInput::checkKeywords
        (
            material,
            {
                "density", "contactAngle", "conductivity", "emissivity",
                "heatCapacity", "youngsModulus", "poissonRatio"
            }
        );
        density_[i] =
            dictionaryInput::getPositive(material, "density", dimDensity);
    }
    readContactLaws();
}


void Foam::grainMaterials::readContactLaws()
{
    table_ = nscd::ContactTable
    (
        std::vector<std::string>(names_.begin(), names_.end())
    );

    const dictionary& laws = dictionaryInput::subDict(dict_, "contactLaws");

    for (const word& name : laws.toc())
    {
        const dictionary& law = dictionaryInput::subDict(laws, name);
        if (name == "default" && !law.found("materials"))
        {
            continue;
        }
        const string allowed("a pair of " + dictionaryInput::listed(names_));
        const Pair<word> pair
        (
            dictionaryInput::getAs<Pair<word>>(law, "materials", allowed)
        );

        Pair<label> ij;
        forAll(pair, k)
        {
            ij[k] = names_.find(pair[k]);
            if (ij[k] < 0)
            {
                dictionaryInput::badValue(law, "materials", pair[k], allowed);
            }
        }

        table_.set(ij[0], ij[1], contactLaw::New(law)->parameters());
        if (!withLaw_.insert(std::minmax(ij[0], ij[1])).second)
        {
            dictionaryInput::badValue
            (
                law, "materials", '(' + pair[0] + ' ' + pair[1] + ')',
                "a pair that has no other law"
            );
        }
    }

    if (laws.found("default") && !laws.subDict("default").found("materials"))
    {
        const nscd::ContactParameters others
        (
            contactLaw::New(laws.subDict("default"))->parameters()
        );
        forAll(names_, i)
        {
            for (label j = i; j < names_.size(); ++j)
            {
                if (withLaw_.insert(std::minmax(i, j)).second)
                {
                    table_.set(i, j, others);
                }
            }
        }
    }
}


Foam::label Foam::grainMaterials::index
(
    const dictionary& dict,
    const word& keyword
) const
{
    return names_.find(dictionaryInput::getWord(dict, keyword, names_));
}


void Foam::grainMaterials::checkPair(const label a, const label b) const
{
    if (!withLaw_.count(std::minmax(a, b)))
    {
        FatalIOErrorInFunction(dict_)
            << "Keyword 'contactLaws' has no law for the materials "
            << names_[a] << " and " << names_[b] << nl
            << "    allowed: a sub-dictionary with 'materials ("
            << names_[a] << ' ' << names_[b] << ");', or one named 'default'"
            << " without 'materials', for all pairs that have none"
            << exit(FatalIOError);
    }
}
