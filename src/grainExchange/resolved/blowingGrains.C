/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

void Foam::resolvedGrains::blow(const volScalarField& speed)
{
    if (!isActive_)
    {
        return;
    }
    List<scalarField> beyond(mesh_.boundary().size());
    forAll(beyond, patchi)
    {
        if (mesh_.boundary()[patchi].coupled())
        {
            beyond[patchi] = speed.boundaryField()[patchi].patchNeighbourField();
        }
    }
    const auto ofOwner = [&](const label patchi, const label facei)
    {
        return
            patchi < 0
          ? speed[mesh_.owner()[facei]]
          : speed[mesh_.boundary()[patchi].faceCells()[facei]];
    };
    const auto ofNeighbour = [&](const label patchi, const label facei)
    {
        return
            patchi < 0
          ? speed[mesh_.neighbour()[facei]]
          : beyond[patchi][facei];
    };

    forSurfaceFaces
    (
        [&]
        (
            const side& inGrain,
            const side& inFluid,
            const label sign,
            const label patchi,
            const label facei
        )
        {
            const scalar c = resolvedFace::at(conductance_, patchi, facei);
            const vector arm
            (
                between(grains_.centres()[label(inGrain.grain)], inFluid.x)
              + inMesh(inGrain.x - inFluid.x)/c
            );
            const scalar w =
                sign > 0
              ? -ofNeighbour(patchi, facei)
              : ofOwner(patchi, facei);
            resolvedFace::at(wallJump_, patchi, facei) += c*w*arm/mag(arm);
        }
    );
}
