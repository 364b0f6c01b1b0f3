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


Foam::contactLaws::Coulomb::Coulomb
(
    const dictionary& dict,
    wordList moreKeywords
)
{
    moreKeywords.append
    (
        wordList({"type", "materials", "friction", "restitution", "rolling"})
    );
    dictionaryInput::checkKeywords(dict, moreKeywords);

    parameters_.friction =
        dictionaryInput::getScalar(dict, "friction", dimless, 0);
    parameters_.restitution =
        dictionaryInput::getScalarOrDefault
        (
            dict, "restitution", dimless, 0, 0, 1
        );
    parameters_.rolling =
        dictionaryInput::getScalarOrDefault(dict, "rolling", dimless, 0, 0);
}


Foam::contactLaws::Coulomb::Coulomb(const dictionary& dict)
:
    Coulomb(dict, wordList())
{}
