/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatLedger.H"

Foam::heatLedger::heatLedger
(
    const grainSystem& grains,
    const fluidHeat& heat,
    const thermalFluid& fluid,
    const grainFluidHeat& exchange
)
:
    grains_(grains),
    heat_(heat),
    fluid_(fluid),
    exchange_(exchange),
    progress_(grains.mesh().time()),
    fluidHeat_(0),
    grainHeat_(0),
    fluidError_(0),
    grainError_(0)
{
    forAll(grains.mesh().boundary(), patchi)
    {
        const fvPatch& patch = grains.mesh().boundary()[patchi];
        if (!patch.coupled() && patch.type() != "empty")
        {
            patches_.append(patchi);
        }
    }
}


Foam::scalar Foam::heatLedger::wallHeat() const
{
    return sum(grains_.temperatures().wallHeat());
}


void Foam::heatLedger::startStep(const transportFlux& flux)
{
    fluidHeat_ = heat_.heat(flux.oldVolume(), fluid_);
    grainHeat_ = grains_.motion().tally().heat;
}


void Foam::heatLedger::endStep(const transportFlux& flux)
{
    const auto error = [](const std::initializer_list<scalar>& gains)
    {
        scalar sum = 0, largest = VSMALL;
        for (const scalar gain : gains)
        {
            sum += gain;
            largest = max(largest, mag(gain));
        }
        return mag(sum)/largest;
    };

    scalar out = 0;
    for (const label patchi : patches_)
    {
        out +=
            heat_.carriedOut(patchi, fluid_)
          + heat_.conductedOut(patchi, fluid_);
    }
    const scalar fluidHeat = heat_.heat(flux, fluid_);
    fluidError_ = error
    ({
        -fluidHeat, fluidHeat_, -out, -exchange_.received(),
        -exchange_.takenByOthers(),
        heat_.fromPlates(), heat_.broughtIn(fluid_)
    });
    fluidHeat_ = fluidHeat;

    const scalar grainHeat = grains_.motion().tally().heat;
    grainError_ = error
    ({
        -grainHeat, grainHeat_, exchange_.received(), exchange_.outside(),
        wallHeat(), -grains_.motion().removed().heat
    });
    grainHeat_ = grainHeat;

    print();
    write();
}


void Foam::heatLedger::print() const
{
    const scalarField& T = heat_.T().primitiveField();
    const scalar least = gMin(T), most = gMax(T);

    Info<< nl
        << "Heat      fluid " << fluidHeat_ << " J, " << least << " to " << most
        << " K, grains " << grainHeat_ << " J, received " << exchange_.received()
        << " J, unaccounted for " << fluidError_ << ", " << grainError_ << endl;
}


void Foam::heatLedger::write()
{
    const scalarField& T = heat_.T().primitiveField();
    const scalar least = gMin(T), most = gMax(T);

    const grainTemperatures& grainT = grains_.temperatures();
    scalar leastGrain = GREAT, mostGrain = 0, capacity = 0;
    for (label i = 0; i < grains_.size(); ++i)
    {
        leastGrain = min(leastGrain, grainT.temperature(i));
        mostGrain = max(mostGrain, grainT.temperature(i));
        capacity += grainT.heatCapacity(i);
    }
    if (!Pstream::master())
    {
        return;
    }

    const char c = ',';
    const polyBoundaryMesh& boundary = grains_.mesh().boundaryMesh();
    if (!file_)
    {
        string names("time,fluidHeat,grainHeat,exchanged,outside,");
        for (const label patchi : patches_)
        {
            names += "convected_" + boundary[patchi].name() + c;
            names += "conducted_" + boundary[patchi].name() + c;
        }
        names += "plates,walls,";
        for (const word& wall : grainT.heatedWalls())
        {
            names += "heatFrom_" + wall + c;
        }
        names +=
            "injected,removed,filled,fluidError,grainError,"
            "leastT,mostT,leastGrainT,mostGrainT,meanGrainT";
        file_ = progress_.newFile("heatLedger", "heatLedger.csv", names.c_str());
        file_().precision(16);
    }

    file_()
        << grains_.mesh().time().value() << c << fluidHeat_ << c << grainHeat_
        << c << exchange_.received() << c << exchange_.outside();
    for (const label patchi : patches_)
    {
        file_()
            << c << heat_.carriedOut(patchi, fluid_)
            << c << heat_.conductedOut(patchi, fluid_);
    }
    file_()
        << c << heat_.fromPlates() << c << wallHeat();
    for (const scalar heat : grainT.wallHeat())
    {
        file_() << c << heat;
    }
    file_()
        << c << grains_.motion().injected().heat
        << c << grains_.motion().removed().heat
        << c << heat_.broughtIn(fluid_) << c << fluidError_ << c << grainError_
        << c << least << c << most << c << min(leastGrain, mostGrain)
        << c << mostGrain
        << c << (capacity > 0 ? grainHeat_/capacity : 0) << endl;
}
