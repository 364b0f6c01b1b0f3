/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Coulomb.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"

namespace Foam
{
namespace contactLaws
{
    defineTypeNameAndDebug(Coulomb, 0);
    addToRunTimeSelectionTable(contactLaw, Coulomb, dictionary);
}
}


Foam::contactLaws::Coulomb::Coulomb(const dictionary& dict)
:
    friction_(dictionaryInput::getScalar(dict, "friction", dimless, 0))
{
    dictionaryInput::checkKeywords(dict, {"type", "materials", "friction"});
}
