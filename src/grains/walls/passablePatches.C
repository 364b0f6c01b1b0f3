/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "passablePatches.H"

#include "cyclicPolyPatch.H"
#include "dictionaryInput.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPieces.H"

namespace
{

using namespace Foam;

//- Patches of the mesh that the sections of grainProperties name
labelHashSet patchesOf
(
    const dictionary& grainProperties,
    const std::initializer_list<word>& sections,
    const polyMesh& mesh
)
{
    labelHashSet patches;
    for (const word& section : sections)
    {
        const dictionary& all = grainProperties.subOrEmptyDict(section);
        for (const word& name : all.toc())
        {
            const dictionary& one = all.subDict(name);
            if (one.get<word>("type") == "patches")
            {
                patches.insert(wallPieces::selectedPatches(one, mesh));
            }
        }
    }
    return patches;
}

} // End anonymous namespace


Foam::wordList Foam::passablePatches
(
    const dictionary& grainProperties,
    const polyMesh& mesh
)
{
    const labelHashSet known
    (
        patchesOf(grainProperties, {"walls", "outlets", "injections"}, mesh)
    );

    DynamicList<word> names;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            !known.found(patch.index())
         && !isA<emptyPolyPatch>(patch)
         && !isA<cyclicPolyPatch>(patch)
         && !isA<processorPolyPatch>(patch)
        )
        {
            names.append(patch.name());
        }
    }
    return wordList(std::move(names));
}


void Foam::refuseMirrors
(
    const dictionary& grainProperties,
    const polyMesh& mesh
)
{
    const labelHashSet walls(patchesOf(grainProperties, {"walls"}, mesh));
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool isMirror =
            isA<symmetryPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch);
        if (isMirror && !walls.found(patch.index()))
        {
            FatalIOErrorInFunction(grainProperties)
                << "Patch " << patch.name() << " of the mesh is of type '"
                << patch.type() << "', in which grains that move have no mirror"
                << nl
                << "    allowed: the patch in 'walls', by a contact law without"
                << " friction for a mirror; or 'motion fixed' in 'coupling'"
                << exit(FatalIOError);
        }
    }
}


void Foam::printPassablePatches
(
    const dictionary& grainProperties,
    const polyMesh& mesh,
    const word& bodies
)
{
    const wordList names(passablePatches(grainProperties, mesh));
    if (names.size())
    {
        Info<< "Patches " << dictionaryInput::listed(names).c_str() << " are neither walls nor"
            << " outlets of " << bodies << ": one of them that passes there is"
            << " lost, which ends the run" << endl;
    }
}
