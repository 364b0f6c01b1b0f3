/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voidFractionMethod.H"

#include "selected.H"

namespace Foam
{
    defineTypeNameAndDebug(voidFractionMethod, 0);
    defineRunTimeSelectionTable(voidFractionMethod, dictionary);
}


Foam::autoPtr<Foam::voidFractionMethod> Foam::voidFractionMethod::New
(
    const dictionary& dict,
    const planarMesh& plane
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict, "void-fraction method"
    )(dict, plane);
}
