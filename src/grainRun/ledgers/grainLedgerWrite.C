/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainLedger.H"

#include "contactReport.H"

void Foam::grainLedger::print() const
{
    Info<< nl
        << "Fluid     Courant number mean " << meanCourant_
        << " max " << maxCourant_
        << ", mixture divergence " << divergence_ << nl;

    contactReport::print(grains_.motion().lastStep());

    Info<< "Volume    mapped to " << mappingError_ << " of a grain, overfull "
        << exchange_.overfull() << " m^3, defect of the step "
        << volumeDefect_ << nl
        << "Momentum  given by the fluid " << exchange_.momentumGiven()
        << " N s, differs by " << momentumError_
        << " from what the grains received" << nl;

    if (carried_.hasCarried())
    {
        const transportFlux& flux = carried_.flux();
        Info<< "Carried   defect " << flux.defect() << " of a cell, correction "
            << flux.correction() << " of the fluid, without room "
            << flux.volumeWithoutRoom() << " m^3, scalars unaccounted "
            << carriedUnaccounted_ << nl;
    }

    const grainTally& injected = grains_.motion().injected();
    if (injected.number)
    {
        Info<< "Inlets    injected " << injected.number << " grains, "
            << injected.volume << " m^3, " << injected.momentum << " N s" << nl;
    }
    const grainTally& removed = grains_.motion().removed();
    if (removed.number)
    {
        Info<< "Outlets   removed " << removed.number << " grains, "
            << removed.volume << " m^3, " << removed.momentum << " N s" << nl;
    }

    const auto percent = [&](const scalar time)
    {
        return std::to_string(std::lround(100*time/progress_.elapsed()));
    };
    progress_.print
    (
        " (contacts " + percent(grains_.motionTime())
      + " %, mapping and exchange " + percent(exchange_.exchangeTime()) + " %)"
    );
}


void Foam::grainLedger::write()
{
    if (!Pstream::master())
    {
        return;
    }

    if (!file_)
    {
        file_ = progress_.newFile
        (
            "ledger", "ledger.csv",
            "time,grainVolume,mappedVolume,mappingError,overfull,"
            "given_x,given_y,given_z,received_x,received_y,received_z,"
            "momentumError,divergence,volumeDefect," CONTACT_COLUMNS
            ",grains,injected,injectedVolume,injectedMomentum_x,"
            "injectedMomentum_y,injectedMomentum_z,removed,removedVolume,"
            "removedMomentum_x,removedMomentum_y,removedMomentum_z,"
            "outside_x,outside_y,outside_z,"
            "fluidMomentum_x,fluidMomentum_y,fluidMomentum_z,"
            "grainMomentum_x,grainMomentum_y,grainMomentum_z,"
            "grainMomentumError,transportDefect,transportCorrection,"
            "volumeWithoutRoom,carriedUnaccounted,motionTime,exchangeTime,elapsedTime"
        );
    }

    const vector& g = exchange_.momentumGiven();
    const vector& r = exchange_.momentumReceived();
    const vector& o = exchange_.impulseOutside();
    const grainTally& injected = grains_.motion().injected();
    const vector& i = injected.momentum;
    const grainTally& removed = grains_.motion().removed();
    const vector& m = removed.momentum;
    const vector& f = fluidMomentum_;
    const vector& p = grainMomentum_;
    const char c = ',';

    file_()
        << mesh_.time().value() << c << grainVolume_ << c << mappedVolume_
        << c << mappingError_ << c << exchange_.overfull()
        << c << g.x() << c << g.y() << c << g.z()
        << c << r.x() << c << r.y() << c << r.z()
        << c << momentumError_ << c << divergence_ << c << volumeDefect_ << c;
    contactReport::write(file_(), grains_.motion().lastStep());
    file_()
        << c << grains_.size() << c << injected.number << c << injected.volume
        << c << i.x() << c << i.y() << c << i.z() << c << removed.number << c << removed.volume
        << c << m.x() << c << m.y() << c << m.z()
        << c << o.x() << c << o.y() << c << o.z()
        << c << f.x() << c << f.y() << c << f.z()
        << c << p.x() << c << p.y() << c << p.z() << c << grainMomentumError_;
    if (carried_.hasCarried())
    {
        const transportFlux& flux = carried_.flux();
        file_()
            << c << flux.defect() << c << flux.correction()
            << c << flux.volumeWithoutRoom() << c << carriedUnaccounted_;
    }
    else
    {
        file_() << ",0,0,0,0";
    }
    file_()
        << c << grains_.motionTime() << c << exchange_.exchangeTime()
        << c << progress_.elapsed() << endl;
}
