/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffused.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "implicitDiffusion.H"

namespace Foam
{
namespace voidFractionMethods
{
    defineTypeNameAndDebug(diffused, 0);
    addToRunTimeSelectionTable(voidFractionMethod, diffused, dictionary);
}
}


Foam::voidFractionMethods::diffused::diffused
(
    const dictionary& dict,
    const grainCells& cells
)
:
    exactOverlap(cells),
    length_(dictionaryInput::getPositive(dict, "length", dimLength)),
    steps_(dictionaryInput::getLabelOrDefault(dict, "steps", 3, 1, 100))
{
    dictionaryInput::checkKeywords(dict, {"type", "length", "steps"});
}


void Foam::voidFractionMethods::diffused::smooth(scalarField& x) const
{
    x = implicitDiffusion
    (
        cells_.mesh(), x, sqr(length_)/(4*steps_), steps_, 1e-13
    );
}
