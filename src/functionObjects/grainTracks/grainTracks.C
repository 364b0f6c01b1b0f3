/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainTracks.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "functionKeywords.H"
#include "grainView.H"
#include "tableDirectory.H"

#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(grainTracks, 0);
    addToRunTimeSelectionTable(functionObject, grainTracks, dictionary);
}
}


Foam::functionObjects::grainTracks::grainTracks
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


bool Foam::functionObjects::grainTracks::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {"grains"});
    ids_.clear();
    if (dict.found("grains"))
    {
        ids_.insert
        (
            dictionaryInput::getAs<labelList>
            (
                dict, "grains", "a list of ids of grains, as (0 17 42);"
                " all are followed without it"
            )
        );
    }

    const auto* grainsPtr =
        mesh_.cfindObject<grainView>(grainView::registryName);

    if (grainsPtr)
    {
        labelHashSet unknown(ids_);
        for (label i = 0; i < grainsPtr->size(); ++i)
        {
            unknown.erase(grainsPtr->id(i));
        }
        // Later on grains may have left
        if (unknown.size() && mesh_.time().value() <= 0)
        {
            dictionaryInput::badValue
            (
                dict, "grains", Foam::name(unknown.sortedToc()[0]),
                "ids of grains; there are "
              + Foam::name(grainsPtr->size()) + " grains, the first is 0"
            );
        }
    }
    return true;
}


Foam::OFstream& Foam::functionObjects::grainTracks::file()
{
    if (!file_)
    {
        const fileName dir(tableDirectory(time_, name()));
        file_.reset(new OFstream(dir/"grains.csv"));
        file_().precision(17);
        file_() << "time,id,x,y,z,vx,vy,vz,wx,wy,wz,fx,fy,fz" << nl;
    }
    return file_();
}


bool Foam::functionObjects::grainTracks::write()
{
    const grainView& grains = grainView::of(mesh_, name());
    if (!Pstream::master())
    {
        return true;
    }

    Ostream& os = file();
    for (label i = 0; i < grains.size(); ++i)
    {
        if (ids_.size() && !ids_.found(grains.id(i)))
        {
            continue;
        }
        os  << time_.timeName() << ',' << grains.id(i);
        for
        (
            const vector& v :
            {
                vector(grains.centre(i)),
                grains.velocity(i),
                grains.spin(i),
                functionObject::postProcess
              ? vector::uniform(std::numeric_limits<scalar>::quiet_NaN())
              : grains.fluidForce(i)
            }
        )
        {
            os  << ',' << v.x() << ',' << v.y() << ',' << v.z();
        }
        os  << nl;
    }
    os.flush();
    return true;
}
