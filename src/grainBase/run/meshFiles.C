/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFiles.H"

#include "argList.H"
#include "OSspecific.H"

void Foam::refuseEmptyMeshFiles(const argList& args)
{
    const fileName dir(args.path()/"constant"/"polyMesh");
    for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"})
    {
        const fileName file(dir/name);
        if (isFile(file, false) && fileSize(file) == 0)
        {
            FatalErrorInFunction
                << "The file " << file << " of the mesh is empty" << nl
                << "    allowed: the file that blockMesh, decomposePar or another"
                << " program made; make the mesh again" << exit(FatalError);
        }
    }
}
