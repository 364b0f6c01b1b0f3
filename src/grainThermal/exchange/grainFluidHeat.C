/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidHeat.H"

#include "combineOverRanks.H"
#include "meanOverGrains.H"

Foam::grainFluidHeat::grainFluidHeat
(
    grainSystem& grains,
    grainFluidExchange& exchange,
    const thermalFluid& fluid,
    const volScalarField& T
)
:
    grainFluidHeat(grains, exchange, fluid, T, fluid, fluid, nullptr)
{}


Foam::grainFluidHeat::grainFluidHeat
(
    grainSystem& grains,
    grainFluidExchange& exchange,
    const thermalFluid& fluid,
    const volScalarField& T,
    const carrier& aroundGrains,
    const conductor& heatAroundGrains,
    otherHeat* others
)
:
    grains_(grains),
    exchange_(exchange),
    fluid_(fluid),
    unresolved_(grains, aroundGrains, heatAroundGrains),
    resolved_(grains, exchange.resolved()),
    others_(others),
    received_(0),
    outside_(0),
    openConductivity_
    (
        IOobject("openConductivity", T.time().timeName(), T.mesh()),
        fluid.kappa()
    )
{
    exchange.findShares();
    setOpenConductivity();
    if (resolved_.conducts())
    {
        // The cells' temperature is the state
        const scalarField mean(meanOverGrains(grains, T));
        scalarField TGrain(grains.size());
        forAll(TGrain, i)
        {
            TGrain[i] =
                exchange.resolved().isResolved(i)
              ? mean[i]
              : grains.temperatures().temperature(i);
        }
        grains.temperatures().setTemperatures(TGrain);
    }
}


void Foam::grainFluidHeat::setOpenConductivity()
{
    openConductivity_ ==
        fluid_.kappaEff()
       *max
        (
            exchange_.fields().fluidShare + exchange_.resolved().locked(),
            transportFlux::least
        );
}


Foam::cellHeat Foam::grainFluidHeat::cells
(
    const volScalarField& T,
    const volVectorField& U
)
{
    exchange_.findShares();
    setOpenConductivity();

    cellHeat result(openConductivity_);
    unresolved_.add(exchange_, U, result);
    resolved_.add(T, openConductivity_, result);
    if (others_)
    {
        others_->add(T, result);
    }

    const plateHeat& plates = fluid_.plates();
    if (plates.coefficient() > 0)
    {
        forAll(T, celli)
        {
            result.add(celli, plates.coefficient(), plates.temperature());
        }
    }
    return result;
}


void Foam::grainFluidHeat::give(const volScalarField& T)
{
    grainTemperatures& grainT = grains_.temperatures();
    const scalar deltaT = T.time().deltaTValue();

    scalarField heat(grains_.size(), Zero);
    unresolved_.addReceived(T, exchange_.resolved(), heat);
    resolved_.addReceived(T, heat);
    sumOverRanks(heat);

    received_ = sum(heat);
    outside_ = 0;
    scalarField TNew(grains_.size());
    forAll(TNew, i)
    {
        scalar gained = heat[i];
        if (grains_.isAtOpening(i))
        {
            gained *= grains_.volume(i)/grains_.mappedVolume()[i];
            outside_ += gained - heat[i];
        }
        TNew[i] = grainT.temperature(i) + gained/grainT.heatCapacity(i);
    }
    grainT.setTemperatures(TNew);
    grainT.conduct(deltaT);

    if (others_)
    {
        others_->take(T);
    }
}
