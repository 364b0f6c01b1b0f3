/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactProblem.H"

#include "addToRunTimeSelectionTable.H"
#include "contactsAreKnown.H"
#include "functionKeywords.H"
#include "grainView.H"
#include "OSspecific.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactProblem, 0);
    addToRunTimeSelectionTable(functionObject, contactProblem, dictionary);
}
}


Foam::functionObjects::contactProblem::contactProblem
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    checkFunctionKeywords(dict, {});
}


bool Foam::functionObjects::contactProblem::write()
{
    if (!contactsAreKnown(name()))
    {
        return true;
    }

    const fileName dir(time_.globalPath()/"postProcessing"/name());
    if (Pstream::master())
    {
        mkDir(dir);
    }
    const fileName file(dir/("problem_" + time_.timeName() + ".hdf5"));
    if (grainView::of(mesh_, name()).writeContactProblem(file))
    {
        Info<< name() << ": wrote " << file << nl;
    }
    else
    {
        Info<< name() << ": no contacts in this step" << nl;
    }
    return true;
}
