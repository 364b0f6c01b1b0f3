/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "missingFluxes.H"

#include "dictionaryInput.H"
#include "surfaceFields.H"

void Foam::reportMissingFluxes(const fvMesh& mesh, const wordList& fluxes)
{
    // Of a time that a run has written
    if (mesh.time().startTimeIndex() == 0)
    {
        return;
    }

    wordList missing;
    for (const word& name : fluxes)
    {
        IOobject io(name, mesh.time().timeName(), mesh);
        if (!returnReduce(io.typeHeaderOk<surfaceScalarField>(true), andOp<bool>()))
        {
            missing.append(name);
        }
    }
    if (missing.size())
    {
        Info<< "Time " << mesh.time().timeName() << " has no "
            << dictionaryInput::listed(missing).c_str() << ": made from U" << nl << endl;
    }
}
