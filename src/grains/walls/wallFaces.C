/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Walls in three dimensions.
\*---------------------------------------------------------------------------*/

#include "wallPieces.H"

#include "dictionaryInput.H"
#include "initialPoints.H"
#include "wallSurface.H"

Foam::wallPieceList<3> Foam::wallPieces::ofPatches
(
    const dictionary& dict,
    const grainSpace<3>& space
)
{
    const tmp<pointField> points(initialPoints(space.mesh()));

    DynamicList<List<point>> local;
    for (const label patchi : selectedPatches(dict, space.mesh()))
    {
        const polyPatch& patch = space.mesh().boundaryMesh()[patchi];
        for (const face& f : patch)
        {
            local.append(List<point>(points(), f));
        }
    }

    wallPieceList<3> result;
    for (const List<point>& polygon : gathered<List<point>>(local))
    {
        wallFace f;
        for (const point& p : polygon)
        {
            f.vertices.push_back(space.fromSpace(p));
        }
        result.push_back(f);
    }
    return result;
}


Foam::wallPieceList<3> Foam::wallPieces::ofSurface
(
    const dictionary& dict,
    const grainSpace<3>& space
)
{
    const fileName file(surfaceFile(dict, space.mesh().time()));
    const triSurface surface(readWallSurface(dict, file));

    wallPieceList<3> result;
    for (const labelledTri& tri : surface)
    {
        wallFace f;
        for (const label pointi : tri)
        {
            f.vertices.push_back(space.fromSpace(surface.points()[pointi]));
        }
        if (tri.mag(surface.points()) > 0)
        {
            result.push_back(f);
        }
    }
    if (result.empty())
    {
        dictionaryInput::badValue(dict, "file", file, "a surface of triangles");
    }
    return result;
}
