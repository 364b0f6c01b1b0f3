/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactsAreKnown.H"

#include "functionObject.H"
#include "messageStream.H"

bool Foam::functionObjects::contactsAreKnown(const word& askedBy)
{
    if (functionObject::postProcess)
    {
        WarningInFunction
            << "The function object '" << askedBy << "' needs the forces of"
            << " contacts, which are not on disk: it writes nothing" << nl
            << "    allowed: to have it in 'functions' while the case runs" << endl;
    }
    return !functionObject::postProcess;
}
