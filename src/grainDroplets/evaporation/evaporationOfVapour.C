/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "evaporation.H"

#include "combineOverRanks.H"
#include "fvc.H"


void Foam::evaporation::carry(vapour& steam, const transportFlux& flux)
{
    if (!steam.isActive())
    {
        return;
    }
    const scalar perVolume = 1/droplets_.properties().vapourDensity;
    cellExchange cells{perVolume*vapour_, perVolume*vapourShare_};
    if (!saturated_)
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
                exchange_.fields().fluidShare + term_.locked(),
                transportFlux::least
            )
        )
    );
    const List<dropletFace> faces(dropletFace::list(term_, D));
    D *= term_.conductance();
    const scalar hold = holding(1, D);

    scalarField diffused(droplets_.size(), Zero);
    vapourStiffness_ = Zero;
    const scalar perShare =
        mesh_.time().deltaTValue()*droplets_.properties().vapourDensity;
    const auto addSmalls = [&](const auto& visit)
    {
        for (const dropletFace& f : smalls_)
        {
            // As for heat
            const scalar h =
                steam.D()*f.conductance
               /(gas_.kappa()[f.cell]*mesh_.V()[f.cell]);
            visit(f, h, saturated_->share(temperature(f.droplet)));
        }
    };

    forAll(vapour_, celli)
    {
        const label d = term_.dropletOf(celli);
        if (d >= 0)
        {
            cells.coefficient[celli] += hold;
            cells.given[celli] += hold*saturated_->share(temperature(d));
        }
    }
    addSmalls
    (
        [&](const dropletFace& f, const scalar h, const scalar share)
        {
            cells.coefficient[f.cell] += h;
            cells.given[f.cell] += h*share;
        }
    );

    steam.carry(flux, D, cells);

    const volScalarField& psi = steam.psi().field();
    forAll(vapour_, celli)
    {
        const label d = term_.dropletOf(celli);
        if (d >= 0)
        {
            diffused[d] +=
                perShare*mesh_.V()[celli]*hold
               *(saturated_->share(temperature(d)) - psi[celli]);
        }
    }
    addSmalls
    (
        [&](const dropletFace& f, const scalar h, const scalar share)
        {
            const scalar perDroplet = perShare*mesh_.V()[f.cell]*h;
            diffused[f.droplet] += perDroplet*(share - psi[f.cell]);
            vapourStiffness_[f.droplet] += perDroplet;
        }
    );
    for (const dropletFace& f : faces)
    {
        vapourStiffness_[f.droplet] += perShare*f.conductance*f.conductivity;
    }
    sumOverRanks(diffused);
    sumOverRanks(vapourStiffness_);

    forAll(diffused, i)
    {
        saturated_->diffuse(i, diffused[i]);
        const scalar T = temperature(i);
        vapourStiffness_[i] *=
            saturated_->slope(T)/(1 - saturated_->share(T));
    }
}
