/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"
#include "lockedGrains.H"
#include "noResolvedTerm.H"

Foam::autoPtr<Foam::resolvedTerm> Foam::resolvedTerm::New
(
    const grainSystem& grains,
    const carrier& fluid
)
{
    const chosenOption option
    (
        chosen(grains.motion().coupling(), grains.voidFraction().resolves())
    );
    if (!option.number)
    {
        return autoPtr<resolvedTerm>(new noResolvedTerm(grains.mesh()));
    }
    return
        option.type == "cutCells"
      ? autoPtr<resolvedTerm>
        (
            new cutGrains
            (
                grains, fluid, *option.number,
                {
                    grains.motion().coupling().subDict("resolvedGrains"),
                    "type", "locked none"
                }
            )
        )
      : autoPtr<resolvedTerm>(new lockedGrains(grains, fluid, *option.number));
}
