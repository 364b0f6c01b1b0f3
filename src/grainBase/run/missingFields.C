/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "missingFields.H"

#include "dictionaryInput.H"
#include "surfaceFields.H"

bool Foam::isThere(const fvMesh& mesh, const word& name)
{
    IOobject io(name, mesh.time().timeName(), mesh);
    return returnReduce(io.typeHeaderOk<surfaceScalarField>(false), andOp<bool>());
}


void Foam::reportMissingFields
(
    const fvMesh& mesh,
    const wordList& fields,
    const string& instead
)
{
    // Of a time that a run has written
    if (mesh.time().startTimeIndex() == 0)
    {
        return;
    }

    wordList missing;
    for (const word& name : fields)
    {
        if (!isThere(mesh, name))
        {
            missing.append(name);
        }
    }
    if (missing.size())
    {
        Info<< "Time " << mesh.time().timeName() << " has no "
            << dictionaryInput::listed(missing).c_str() << ": " << instead.c_str() << nl << endl;
    }
}
