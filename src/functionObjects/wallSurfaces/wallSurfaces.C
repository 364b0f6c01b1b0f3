/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurfaces.H"

#include "addToRunTimeSelectionTable.H"
#include "functionKeywords.H"
#include "grainView.H"
#include "polyDataFile.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(wallSurfaces, 0);
    addToRunTimeSelectionTable(functionObject, wallSurfaces, dictionary);
}
}


Foam::functionObjects::wallSurfaces::wallSurfaces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    checkFunctionKeywords(dict, {});
}


bool Foam::functionObjects::wallSurfaces::write()
{
    const grainView& grains = grainView::of(mesh_, name());
    if (!Pstream::master())
    {
        return true;
    }
    const std::vector<wallOutline> walls(grains.walls());
    List<pointField> outlines(label(walls.size()));
    forAll(outlines, i)
    {
        outlines[i] = walls[i].points;
    }
    const bool planar = walls.size() && walls.front().points.size() == 2;

    polyDataFile file
    (
        time_, name(), "walls", planar ? "LINES" : "POLYGONS", outlines
    );
    file.scalars("body", "int", [&](label i) { return walls[i].body; });
    return true;
}
