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
    conduction_(grains),
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
    checkProperties(T);
    if (fluid.isTurbulent() && others)
    {
        exchange.resolved().requireWholeCells("turbulence");
    }
    exchange.followGrains();
    setOpenConductivity();
    noteGapsTwice();
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


void Foam::grainFluidHeat::noteGapsTwice() const
{
    const dictionary& heat =
        grains_.motion().coupling().parent().subOrEmptyDict("heat");
    if (heat.found("throughFluid") && conduction_.isActive())
    {
        Info<< "'throughFluid' of 'heat' and the law 'conductivity' of 'coupling' both"
            << " have what the fluid between near grains conducts" << endl;
    }
    label resolved = 0;
    for (label i = 0; i < grains_.size(); ++i)
    {
        resolved +=
            exchange_.resolved().leavesParts() || exchange_.resolved().isResolved(i);
    }
    if (resolved > 1 && heat.found("throughFluid"))
    {
        Info<< "'throughFluid' of 'heat': the fluid between " << resolved
            << " resolved grains conducts, too, and counts twice between them"
            << endl;
    }
}


void Foam::grainFluidHeat::checkProperties(const volScalarField& T) const
{
    scalar least = min(T).value(), most = max(T).value();
    const auto see = [&](const scalar T)
    {
        least = min(least, T);
        most = max(most, T);
    };
    for (label i = 0; i < grains_.size(); ++i)
    {
        see(grains_.temperatures().temperature(i));
    }
    if (fluid_.plates().coefficient() > 0)
    {
        see(fluid_.plates().temperature());
    }
    fluid_.checkRange(least, most);
}


void Foam::grainFluidHeat::setOpenConductivity()
{
    const volScalarField open
    (
        max
        (
            exchange_.resolved().amongSmall(exchange_.fields().fluidShare),
            transportFlux::least
        )
    );
    openConductivity_ == fluid_.kappaEff()*open;
    if (conduction_.isActive())
    {
        const volScalarField& kappa = fluid_.kappa();
        openConductivity_ +=
            kappa*(conduction_.ratio(open, kappa, exchange_.resolved()) - open);
    }
}


void Foam::grainFluidHeat::setOnPatches
(
    const surfaceScalarField& conductivity
)
{
    forAll(conductivity.boundaryField(), patchi)
    {
        fvPatchScalarField& patch = openConductivity_.boundaryFieldRef()[patchi];
        if (!patch.coupled())
        {
            patch == conductivity.boundaryField()[patchi];
        }
    }
}


Foam::cellHeat Foam::grainFluidHeat::cells
(
    const volScalarField& T,
    const volVectorField& U
)
{
    exchange_.followGrains();
    setOpenConductivity();

    if (others_)
    {
        others_->follow();
    }
    cellHeat result(openConductivity_, conduction_.isActive());
    unresolved_.add(exchange_, U, others_, result);
    resolved_.add(T, openConductivity_, fluid_, U, result);
    nodes_ = std::make_unique<heatNodes>
    (
        grains_, exchange_.resolved(), fluid_.capacity(),
        unresolved_.conductance() + resolved_.conductance(),
        resolved_.lockedVolume(),
        others_,
        unresolved_.toOthers()
    );
    if (others_)
    {
        others_->add(T, result);
    }
    setOnPatches(result.conductivity);

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


Foam::bodyExchange* Foam::grainFluidHeat::bodies()
{
    return nodes_->isAlone() ? nullptr : nodes_.get();
}


void Foam::grainFluidHeat::give(const volScalarField& T)
{
    grainTemperatures& grainT = grains_.temperatures();
    const scalar deltaT = T.time().deltaTValue();

    scalarField heat(deltaT*(nodes_->fromFluid(T) + nodes_->fromOthers()));
    resolved_.addReceived(T, heat);
    sumOverRanks(heat);
    const scalarField linked(deltaT*nodes_->throughNetwork());

    // What cells have of grains came through contacts, too
    const scalarField held(deltaT*nodes_->heldInCells());

    received_ = 0;
    outside_ = 0;
    scalarField TNew(grains_.size());
    forAll(TNew, i)
    {
        const scalar whole = nodes_->whole(i);
        if (nodes_->isInCells()[i])
        {
            heat[i] = held[i] - linked[i]/whole;
        }
        received_ += heat[i];
        outside_ += (whole - 1)*heat[i];
        TNew[i] =
            grainT.temperature(i)
          + (whole*heat[i] + linked[i])/grainT.heatCapacity(i);
    }
    grainT.setTemperatures(TNew);
    const label nWalls = grainT.heatedWalls().size();
    scalarList walls(nodes_->fromReservoirs(nWalls));
    for (scalar& given : walls)
    {
        given *= deltaT;
    }
    grainT.setWallHeat(walls);

    if (others_)
    {
        others_->takeFromGrains(deltaT*nodes_->toOthersInCells());
        others_->take(T);
    }
}
