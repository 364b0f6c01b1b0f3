/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainLedger.H"

#include "OSspecific.H"

namespace
{

// Hours, minutes and seconds as a person reads them
Foam::string duration(const double seconds)
{
    char text[64];
    const long s = std::lround(seconds);
    if (s >= 3600)
    {
        std::snprintf
        (
            text, sizeof(text), "%ld h %02ld min", s/3600, s%3600/60
        );
    }
    else if (s >= 60)
    {
        std::snprintf(text, sizeof(text), "%ld min %02ld s", s/60, s%60);
    }
    else
    {
        std::snprintf(text, sizeof(text), "%.1f s", seconds);
    }
    return text;
}

}


void Foam::grainLedger::print() const
{
    const nscd::StepReport& step = grains_.lastStep();
    const Time& runTime = mesh_.time();

    Info<< nl
        << "Fluid     Courant number mean " << meanCourant_
        << " max " << maxCourant_
        << ", mixture divergence " << divergence_ << nl
        << "Contacts  " << label(step.active) << " active of "
        << label(step.contacts) << " possible, " << label(step.subSteps)
        << " sub-steps, " << label(step.sweeps) << " sweeps, residual "
        << step.residual << " m/s" << (step.converged ? "" : " (sweep limit)")
        << nl
        << "          worst overlap " << step.worstOverlap << " m, mean "
        << step.meanOverlap << " m, fastest grain " << step.maxVelocity
        << " m/s" << nl
        << "Volume    mapped to " << mappingError_ << " of a grain, overfull "
        << exchange_.overfull() << " m^3, defect of the step "
        << volumeDefect_ << nl
        << "Momentum  given by the fluid " << exchange_.momentumGiven()
        << " N s, differs by " << momentumError_
        << " from what the grains received" << nl;

    const scalar done = runTime.value() - startTime_;
    const scalar toDo = runTime.endTime().value() - runTime.value();

    Info<< "Elapsed   " << duration(elapsed()).c_str() << ", about "
        << duration(elapsed()/max(done, VSMALL)*max(toDo, 0.0)).c_str()
        << " to go" << endl;
}


void Foam::grainLedger::write()
{
    if (!Pstream::master())
    {
        return;
    }

    if (!file_)
    {
        const Time& runTime = mesh_.time();
        const fileName dir
        (
            runTime.globalPath()/"postProcessing"/"ledger"
           /Time::timeName(startTime_)
        );
        mkDir(dir);
        file_.reset(new OFstream(dir/"ledger.csv"));
        file_().precision(12);
        file_()
            << "time,grainVolume,mappedVolume,mappingError,overfull,"
            << "given_x,given_y,given_z,received_x,received_y,received_z,"
            << "momentumError,divergence,volumeDefect,contacts,active,sweeps,"
            << "residual,worstOverlap,meanOverlap,maxVelocity,contactTime,"
            << "elapsedTime" << nl;
    }

    const nscd::StepReport& step = grains_.lastStep();
    const vector& g = exchange_.momentumGiven();
    const vector& r = exchange_.momentumReceived();
    const char c = ',';

    file_()
        << mesh_.time().value() << c << grainVolume_ << c << mappedVolume_
        << c << mappingError_ << c << exchange_.overfull()
        << c << g.x() << c << g.y() << c << g.z()
        << c << r.x() << c << r.y() << c << r.z()
        << c << momentumError_ << c << divergence_ << c << volumeDefect_
        << c << label(step.contacts) << c << label(step.active)
        << c << label(step.sweeps) << c << step.residual
        << c << step.worstOverlap << c << step.meanOverlap
        << c << step.maxVelocity
        << c << step.detectionTime + step.solutionTime
        << c << elapsed() << endl;
}
