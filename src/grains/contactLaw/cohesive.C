/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cohesive.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace contactLaws
{
    defineTypeNameAndDebug(cohesive, 0);
    addToRunTimeSelectionTable(contactLaw, cohesive, dictionary);
}
}


Foam::contactLaws::cohesive::cohesive(const dictionary& dict)
:
    Coulomb(dict, wordList({"cohesion", "tension", "cohesionDelay", "psi0"}))
{
    parameters_.cohesion =
        dictionaryInput::getScalarOrDefault(dict, "cohesion", dimForce, 0, 0);
    parameters_.tension =
        dictionaryInput::getScalarOrDefault
        (
            dict, "tension", dimForce/dimLength, 0, 0
        );
    parameters_.cohesionDelay =
        dictionaryInput::getScalarOrDefault
        (
            dict, "cohesionDelay", dimTime, 0, 0
        );
    if (dict.found("psi0"))
    {
        parameters_.cohesionBelow =
            dictionaryInput::getScalar(dict, "psi0", dimless, 0, 1);
    }
}
