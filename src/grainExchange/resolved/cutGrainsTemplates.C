/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

template<class Function>
void Foam::cutGrains::forNeighbours
(
    const volVectorField& U,
    const Function& f
) const
{
    const surfaceScalarField& open = cells_.open();
    const volScalarField& fluid = cells_.fluid();
    const volVectorField& shift = cells_.shift();
    const surfaceVectorField d(mesh_.delta());
    forAll(mesh_.owner(), i)
    {
        const label P = mesh_.owner()[i], N = mesh_.neighbour()[i];
        if (open[i] > 0)
        {
            const vector way(d[i] + shift[N] - shift[P]);
            const vector out(mesh_.Sf()[i]/mesh_.magSf()[i]);
            f(P, neighbour{way, out, U[N], fluid[N]});
            f(N, neighbour{-way, -out, U[P], fluid[P]});
        }
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField way
        (
            patch.delta() + shift.boundaryField()[patchi].patchNeighbourField()
        );
        const vectorField out(patch.nf());
        const vectorField velocity(U.boundaryField()[patchi].patchNeighbourField());
        const scalarField whole(fluid.boundaryField()[patchi].patchNeighbourField());
        forAll(way, i)
        {
            const label c = patch.faceCells()[i];
            if (open.boundaryField()[patchi][i] > 0)
            {
                f(c, neighbour{way[i] - shift[c], out[i], velocity[i], whole[i]});
            }
        }
    }
}
