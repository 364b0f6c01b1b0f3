/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

template<class Function>
void Foam::resolvedGrains::forLinks(const Function& f) const
{
    const vectorField& C = mesh_.C();
    const auto sideOf = [&](const label celli)
    {
        return side{grain_[celli], C[celli]};
    };

    forAll(mesh_.owner(), facei)
    {
        const label own = mesh_.owner()[facei];
        const label nei = mesh_.neighbour()[facei];
        if (grain_[own] >= 0 || grain_[nei] >= 0)
        {
            f(sideOf(own), sideOf(nei), -1, facei);
        }
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const scalarField grain
        (
            grain_.boundaryField()[patchi].patchNeighbourField()
        );
        const vectorField delta(patch.delta());

        forAll(patch, i)
        {
            const side own(sideOf(patch.faceCells()[i]));
            if (own.isLocked() || grain[i] >= 0)
            {
                f(own, side{grain[i], own.x + delta[i]}, patchi, i);
            }
        }
    }
}


template<class Function>
void Foam::resolvedGrains::forSurfaceFaces(const Function& f) const
{
    forLinks
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label patchi,
            const label facei
        )
        {
            if (own.isLocked() && !nei.isLocked())
            {
                f(own, nei, 1, patchi, facei);
            }
            else if (nei.isLocked() && !own.isLocked())
            {
                f(nei, own, -1, patchi, facei);
            }
        }
    );
}


template<class Function>
void Foam::resolvedGrains::forFluidFaces(const Function& f) const
{
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
            if (patchi < 0 || sign > 0)
            {
                f(inGrain, inFluid, sign, patchi, facei);
            }
        }
    );
}
