/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inputDictionary.H"

#include "Time.H"

Foam::inputDictionary::inputDictionary
(
    const word& name,
    const objectRegistry& db
)
:
    IOdictionary
    (
        IOobject
        (
            name, db.time().constant(), db,
            IOobject::MUST_READ_IF_MODIFIED, IOobject::NO_WRITE
        )
    )
{}


Foam::inputDictionary::inputDictionary
(
    const word& name,
    const objectRegistry& db,
    const dictionary& entries
)
:
    IOdictionary
    (
        IOobject
        (
            name, db.time().constant(), db,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        entries
    )
{}


bool Foam::inputDictionary::readIfModified()
{
    if (modified())
    {
        for (const label watch : watchIndices())
        {
            fileHandler().setUnmodified(watch);
        }
        WarningInFunction
            << (db().time().constant()/IOobject::name()).c_str()
            << " has changed. It is read at the start alone: this run goes on with what"
            << " it had then" << endl;
    }
    return false;
}
