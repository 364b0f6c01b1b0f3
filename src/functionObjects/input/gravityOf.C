/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityOf.H"

#include "uniformDimensionedFields.H"

Foam::vector Foam::functionObjects::gravityOf
(
    const fvMesh& mesh,
    const word& askedBy
)
{
    const auto* g =
        mesh.time().cfindObject<uniformDimensionedVectorField>("g");
    if (g)
    {
        return g->value();
    }
    FatalErrorInFunction
        << "The function object '" << askedBy << "' needs gravity, and the solver"
        << " has not read constant/g" << nl
        << "    allowed: a solver of grains" << exit(FatalError);
    return Zero;
}
