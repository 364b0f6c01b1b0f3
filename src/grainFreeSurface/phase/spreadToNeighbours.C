/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spreadToNeighbours.H"

void Foam::spreadToNeighbours(volScalarField& x)
{
    x.correctBoundaryConditions();
    const scalarField before(x.primitiveField());
    const fvMesh& mesh = x.mesh();
    const auto take =
        [&](const label celli, const scalar value)
        {
            if (before[celli] == 0)
            {
                x[celli] = max(x[celli], value);
            }
        };
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        take(P, before[N]);
        take(N, before[P]);
    }
    for (const fvPatchScalarField& patch : x.boundaryField())
    {
        if (patch.coupled())
        {
            const scalarField beyond(patch.patchNeighbourField());
            forAll(beyond, i)
            {
                take(patch.patch().faceCells()[i], beyond[i]);
            }
        }
    }
}
