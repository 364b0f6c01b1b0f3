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
    const grainCells& cells
)
{
    return dictionaryInput::selected
    (
        *dictionaryConstructorTablePtr_, dict
    )(dict, cells);
}


void Foam::voidFractionMethod::smooth(vectorField& x) const
{
    if (!smooths())
    {
        return;
    }
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (cells_.mesh().solutionD()[d] == 1)
        {
            scalarField component(x.component(d));
            smooth(component);
            x.replace(d, component);
        }
    }
}


void Foam::voidFractionMethod::appendPoint
(
    const point& x,
    const scalar radius,
    const scalar volume,
    const vector& arm,
    const label hint,
    overlapList& overlaps
) const
{
    const scalar small = 1e-3*radius;
    const scalar scale = volume/cells_.volume(small);

    label k = overlaps.size();
    cells_.appendOverlaps({x, small}, hint, overlaps);
    for (; k < overlaps.size(); ++k)
    {
        overlaps.volume[k] *= scale;
        overlaps.arm[k] = arm;
    }
}
