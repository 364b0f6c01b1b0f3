/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFiles.H"

#include "argList.H"
#include "OSspecific.H"

void Foam::refuseDamagedMeshFiles(const argList& args)
{
    const fileName dir(args.path()/"constant"/"polyMesh");
    const bool isMesh = isFile(dir/"points", true) || isFile(dir/"faces", true);
    for (const char* name : {"points", "faces", "owner", "neighbour", "boundary"})
    {
        const fileName file(dir/name);
        if (isMesh && !isFile(file, true))
        {
            FatalErrorInFunction
                << "The file " << file << " of the mesh is missing" << nl
                << "    allowed: points, faces, owner, neighbour and boundary,"
                << " as blockMesh, decomposePar or another program made them;"
                << " make the mesh again" << exit(FatalError);
        }
        if (isFile(file, false) && fileSize(file) == 0)
        {
            FatalErrorInFunction
                << "The file " << file << " of the mesh is empty" << nl
                << "    allowed: the file that blockMesh, decomposePar or another"
                << " program made; make the mesh again" << exit(FatalError);
        }
    }
}
