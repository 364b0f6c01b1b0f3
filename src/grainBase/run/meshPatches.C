/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPatches.H"

#include "coupledPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "error.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "Time.H"

namespace
{

//- Has every face another one on the other side?
bool joinsWholeFaces(const Foam::polyPatch& patch)
{
    return
        !Foam::isA<Foam::coupledPolyPatch>(patch)
     || Foam::isA<Foam::cyclicPolyPatch>(patch)
     || Foam::isA<Foam::processorPolyPatch>(patch);
}

}

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

        if (!joinsWholeFaces(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of " << file
                << " is of type '" << patch.type() << "'" << nl
                << "    allowed: patches that are not coupled, or 'cyclic', face"
                << " by face" << exit(FatalError);
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
