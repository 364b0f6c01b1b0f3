/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallForces.H"

#include "addToRunTimeSelectionTable.H"
#include "contactsAreKnown.H"
#include "dictionaryInput.H"
#include "functionKeywords.H"
#include "grainView.H"
#include "tableDirectory.H"

#include <algorithm>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(wallForces, 0);
    addToRunTimeSelectionTable(functionObject, wallForces, dictionary);
}
}


Foam::functionObjects::wallForces::wallForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


bool Foam::functionObjects::wallForces::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {"walls", "origin"});

    dict_ = dict;
    origin_ = dictionaryInput::getVectorOrZero(dict, "origin");

    const auto* grainsPtr =
        mesh_.cfindObject<grainView>(grainView::registryName);
    if (grainsPtr)
    {
        findWalls(grainsPtr->wallNames());
    }
    return true;
}


void Foam::functionObjects::wallForces::findWalls(const wordList& all)
{
    const wordList last(names_);
    PtrList<OFstream> lastFiles(std::move(files_));
    names_ = all;
    if (dict_.found("walls"))
    {
        names_ = dictionaryInput::getAs<wordList>
        (
            dict_, "walls", "a list of " + dictionaryInput::listed(all)
        );
    }
    walls_.resize(names_.size());
    forAll(names_, i)
    {
        walls_[i] = all.find(names_[i]);
        if (walls_[i] < 0)
        {
            dictionaryInput::badValue
            (
                dict_, "walls", names_[i],
                "entries of 'walls' of constant/grainProperties "
              + dictionaryInput::listed(all)
            );
        }
    }

    // Tables go on where their walls stay
    files_.resize(names_.size());
    forAll(names_, i)
    {
        const label before = last.find(names_[i]);
        if (before >= 0 && before < lastFiles.size())
        {
            files_.set(i, lastFiles.set(before, nullptr));
        }
    }
}


void Foam::functionObjects::wallForces::openFiles()
{
    const fileName dir(tableDirectory(time_, name()));
    forAll(names_, i)
    {
        if (!files_.set(i))
        {
            files_.set(i, new OFstream(dir/names_[i] + ".csv"));
            files_[i].precision(12);
            files_[i] << "time,contacts,fx,fy,fz,mx,my,mz" << nl;
        }
    }
}


bool Foam::functionObjects::wallForces::write()
{
    if (!contactsAreKnown(name()))
    {
        return true;
    }

    const grainView& grains = grainView::of(mesh_, name());
    if (walls_.empty())
    {
        findWalls(grains.wallNames());
    }
    const std::vector<grainView::contact> contacts(grains.contacts());
    const std::vector<grainView::wallLoad> loads(grains.wallLoads());
    if (!Pstream::master())
    {
        return true;
    }
    openFiles();
    forAll(walls_, i)
    {
        const label number = std::count_if
        (
            contacts.begin(), contacts.end(),
            [&](const grainView::contact& c) { return c.wall == walls_[i]; }
        );
        vector force(Zero), moment(Zero);
        for (const grainView::wallLoad& load : loads)
        {
            if (load.wall == walls_[i])
            {
                force += load.force;
                moment += ((load.place - origin_) ^ load.force) + load.moment;
            }
        }
        files_[i]
            << time_.timeName() << ',' << number
            << ',' << force.x() << ',' << force.y() << ',' << force.z()
            << ',' << moment.x() << ',' << moment.y() << ',' << moment.z()
            << endl;
    }
    return true;
}
