/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "initialPoints.H"

#include "pointIOField.H"
#include "polyMesh.H"
#include "Time.H"

Foam::tmp<Foam::pointField> Foam::initialPoints(const polyMesh& mesh)
{
    if (mesh.pointsInstance() == mesh.facesInstance())
    {
        return tmp<pointField>(mesh.points());
    }
    const pointIOField points
    (
        IOobject
        (
            "points",
            mesh.facesInstance(),
            polyMesh::meshSubDir,
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    if (points.size() != mesh.nPoints())
    {
        FatalErrorInFunction
            << "File " << points.objectPath() << " has " << points.size()
            << " points, the mesh " << mesh.nPoints() << nl
            << "    allowed: the mesh before it moved" << exit(FatalError);
    }
    return tmp<pointField>(new pointField(points));
}
