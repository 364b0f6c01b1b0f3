/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "combineOverRanks.H"
#include "fvc.H"


void Foam::evaporation::thinFilms(surfaceScalarField& D) const
{
    const scalarField& psi = steam_.psi().field();
    volScalarField share
    (
        IOobject("shareOfDroplet", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("none", dimless, -1)
    );
    volScalarField inGas
    (
        IOobject("shareOfGas", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    inGas.primitiveFieldRef() = psi;
    forAll(share, celli)
    {
        const label d = term_.dropletOf(celli);
        if (d >= 0)
        {
            share[celli] = saturated_->share(temperature(d));
        }
    }
    share.correctBoundaryConditions();
    inGas.correctBoundaryConditions();

    const auto thin =
        [](scalar& D, scalar shareP, scalar shareN, scalar psiP, scalar psiN)
    {
        if ((shareP < 0) != (shareN < 0))
        {
            D *= saturatedSurface::diffusing
            (
                max(shareP, shareN), shareP < 0 ? psiP : psiN
            );
        }
    };
    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei], N = mesh_.neighbour()[facei];
        thin(D[facei], share[P], share[N], inGas[P], inGas[N]);
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& s = share.boundaryField()[patchi];
        if (!s.coupled())
        {
            continue;
        }
        const fvPatchScalarField& p = inGas.boundaryField()[patchi];
        const scalarField shareP(s.patchInternalField());
        const scalarField shareN(s.patchNeighbourField());
        const scalarField psiP(p.patchInternalField());
        const scalarField psiN(p.patchNeighbourField());
        scalarField& DofPatch = D.boundaryFieldRef()[patchi];
        forAll(s, i)
        {
            thin(DofPatch[i], shareP[i], shareN[i], psiP[i], psiN[i]);
        }
    }
}


void Foam::evaporation::carry(vapour& steam, const transportFlux& flux)
{
    if (!steam.isActive())
    {
        return;
    }
    const scalar perVolume = 1/droplets_.properties().vapourDensity;
    cellExchange cells{perVolume*entering_, perVolume*vapourShare_};
    if (!saturated_ && !cut_)
    {
        steam.carry(flux, steam.diffusivity(flux.fraction()), cells);
        return;
    }

    surfaceScalarField D
    (
        steam.diffusivity
        (
            max
            (
                term_.amongSmall(exchange_.fields().fluidShare),
                transportFlux::least
            )
        )
    );
    if (!saturated_)
    {
        D *= cut_->cells().conductance();
        steam.carry(flux, D, cells);
        return;
    }

    const volScalarField& psi = steam.psi().field();
    const auto shareOf = [&](const label d)
    {
        return saturated_->share(temperature(d));
    };
    List<dropletFace> faces;
    if (cut_)
    {
        D *= cut_->part(psi, shareOf);
    }
    else
    {
        thinFilms(D);
        faces = dropletFace::list(term_, D);
        D *= term_.conductance();
        dropletFace::shut(term_, D);
    }
    const scalar hold = holding(1, D);

    forAll(vapour_, celli)
    {
        const label d = holder_[celli];
        if (d >= 0)
        {
            cells.coefficient[celli] += hold;
            cells.given[celli] += hold*shareOf(d);
        }
    }
    // As for heat
    List<dropletFace> inCells(inCells_);
    for (dropletFace& f : inCells)
    {
        const scalar share = shareOf(f.droplet);
        f.conductivity =
            steam.D()*saturatedSurface::diffusing(share, psi[f.cell]);
    }
    for (const List<dropletFace>& all : {faces, inCells})
    {
        for (const dropletFace& f : all)
        {
            const scalar h = f.coefficient(mesh_.V()[f.cell]);
            cells.coefficient[f.cell] += h;
            cells.given[f.cell] += h*shareOf(f.droplet);
        }
    }

    steam.carry(flux, D, cells);

    const scalar perShare =
        mesh_.time().deltaTValue()*droplets_.properties().vapourDensity;
    scalarField diffused(droplets_.size(), Zero);
    scalarField through(droplets_.size(), Zero);
    vapourStiffness_ = Zero;
    forAll(vapour_, celli)
    {
        const label d = holder_[celli];
        if (d >= 0)
        {
            diffused[d] +=
                perShare*mesh_.V()[celli]*hold*(shareOf(d) - psi[celli]);
        }
    }
    for (const List<dropletFace>& all : {faces, inCells})
    {
        for (const dropletFace& f : all)
        {
            const scalar share = shareOf(f.droplet);
            const scalar flow = saturatedSurface::flow(share, psi[f.cell]);
            const scalar perDroplet = perShare*f.conductance*f.conductivity;
            const scalar diffusing = perDroplet*(share - psi[f.cell]);
            diffused[f.droplet] += diffusing;
            through[f.droplet] += diffusing*flow;
            vapourStiffness_[f.droplet] += perDroplet*flow;
        }
    }
    for (const inflow& f : condensing_)
    {
        diffused[f.droplet] += mesh_.time().deltaTValue()*f.rate*psi[f.cell];
    }
    sumOverRanks(diffused);
    sumOverRanks(through);
    sumOverRanks(vapourStiffness_);

    forAll(diffused, i)
    {
        saturated_->diffuse(i, diffused[i] - notCarried_[i]);
        saturated_->pass(i, through[i]/mesh_.time().deltaTValue());
        vapourStiffness_[i] *= saturated_->slope(temperature(i));
    }
}
