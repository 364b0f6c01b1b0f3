/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stillPatches.H"

#include "dictionaryInput.H"
#include "wallPieces.H"

Foam::stillPatches::stillPatches
(
    const dictionary& walls,
    const fvMesh& mesh
)
:
    mesh_(mesh),
    walls_(walls)
{
    for (const word& name : walls.toc())
    {
        const dictionary& wall = dictionaryInput::subDict(walls, name);
        if (wall.get<word>("type") == "patches" && !wall.found("motion"))
        {
            patches_.append(wallPieces::selectedPatches(wall, mesh));
        }
    }
    keep();
}


void Foam::stillPatches::keep()
{
    centres_.resize(patches_.size());
    normals_.resize(patches_.size());
    forAll(patches_, i)
    {
        const fvPatch& patch = mesh_.boundary()[patches_[i]];
        centres_[i] = patch.Cf();
        normals_[i] = patch.nf();
    }
}


void Foam::stillPatches::meshChanged()
{
    if (mesh_.topoChanging())
    {
        keep();
        return;
    }

    // Of the mesh's extent: round-off of a motion along the patch
    constexpr scalar tolerance = 1e-6;

    forAll(patches_, i)
    {
        const fvPatch& patch = mesh_.boundary()[patches_[i]];
        const scalar moved = gMax
        (
            mag((patch.Cf() - centres_[i]) & normals_[i])()
        );
        if (moved > tolerance*mesh_.bounds().mag())
        {
            FatalIOErrorInFunction(walls_)
                << "Patch '" << patch.name() << "' has moved by " << moved
                << " m across itself at time " << mesh_.time().timeName()
                << ", but the wall of grains that it is has no 'motion'" << nl
                << "    allowed: patches that keep their planes, or walls with"
                << " the 'motion' that the mesh gives the patch"
                << exit(FatalIOError);
        }
    }
}
