/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPatches.H"

#include "error.H"
#include "polyMesh.H"
#include "Time.H"

void Foam::requireWholePatches(const polyMesh& mesh)
{
    const fileName file
    (
        mesh.time().path()/mesh.facesInstance()/polyMesh::meshSubDir/"boundary"
    );
    label next = mesh.nInternalFaces();
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.start() != next || patch.start() + patch.size() > mesh.nFaces())
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of " << file
                << " has startFace " << patch.start() << " and nFaces "
                << patch.size() << nl
                << "    allowed: patches that follow on each other, this one"
                << " from face " << next << ", of " << mesh.nFaces()
                << " faces in all; make the mesh again" << exit(FatalError);
        }
        next += patch.size();

        if (patch.type() == "genericPatch")
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of " << file
                << " has a type that OpenFOAM does not know" << nl
                << "    allowed: " << polyPatch::dictionaryConstructorTablePtr_
                    ->sortedToc()
                << exit(FatalError);
        }
    }
    if (next != mesh.nFaces())
    {
        FatalErrorInFunction
            << "The patches of " << file << " end at face " << next
            << " of " << mesh.nFaces() << nl
            << "    allowed: patches that have all faces of the boundary; make"
            << " the mesh again" << exit(FatalError);
    }
}
