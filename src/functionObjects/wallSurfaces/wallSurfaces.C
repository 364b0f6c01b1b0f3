/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurfaces.H"

#include "addToRunTimeSelectionTable.H"
#include "grainView.H"
#include "OFstream.H"
#include "OSspecific.H"

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
{}


bool Foam::functionObjects::wallSurfaces::write()
{
    const grainView& grains = grainView::of(mesh_, name());
    if (!Pstream::master())
    {
        return true;
    }
    const std::vector<wallOutline> walls(grains.walls());
    label nPoints = 0;
    for (const wallOutline& wall : walls)
    {
        nPoints += wall.points.size();
    }

    const fileName dir(time_.globalPath()/"postProcessing"/name());
    mkDir(dir);
    OFstream os(dir/("walls_" + time_.timeName() + ".vtk"));
    os.precision(10);
    os  << "# vtk DataFile Version 3.0" << nl
        << "walls at time " << time_.timeName() << nl
        << "ASCII" << nl
        << "DATASET POLYDATA" << nl
        << "POINTS " << nPoints << " double" << nl;
    for (const wallOutline& wall : walls)
    {
        for (const point& p : wall.points)
        {
            os  << p.x() << ' ' << p.y() << ' ' << p.z() << nl;
        }
    }

    const bool planar = walls.size() && walls.front().points.size() == 2;
    os  << (planar ? "LINES " : "POLYGONS ")
        << label(walls.size()) << ' ' << label(walls.size()) + nPoints << nl;
    label next = 0;
    for (const wallOutline& wall : walls)
    {
        os  << wall.points.size();
        for (label i = 0; i < wall.points.size(); ++i)
        {
            os  << ' ' << next++;
        }
        os  << nl;
    }

    os  << "CELL_DATA " << label(walls.size()) << nl
        << "SCALARS body int 1" << nl << "LOOKUP_TABLE default" << nl;
    for (const wallOutline& wall : walls)
    {
        os  << wall.body << nl;
    }
    return true;
}
