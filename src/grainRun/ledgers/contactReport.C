/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactReport.H"

#include "IOstreams.H"
#include "label.H"

void Foam::contactReport::print(const nscd::StepReport& step)
{
    Info<< "Contacts  " << label(step.active) << " active of "
        << label(step.contacts) << " possible, " << label(step.subSteps)
        << " sub-steps, " << label(step.sweeps) << " sweeps, residual "
        << step.residual << " m/s" << (step.converged ? "" : " (not converged)")
        << nl;
    if (step.impacts)
    {
        Info<< "          " << label(step.impacts) << " impacts, "
            << label(step.exhausted) << " contacts with too many" << nl;
    }
    if (step.leftOverlap > 0 && !step.converged)
    {
        Info<< "          overlap not removed " << step.leftOverlap << " m" << nl;
    }
    Info<< "          worst overlap " << step.worstOverlap << " m, mean "
        << step.meanOverlap << " m, fastest grain " << step.maxVelocity
        << " m/s" << nl;
}


void Foam::contactReport::write(Ostream& os, const nscd::StepReport& step)
{
    const char c = ',';
    os  << label(step.contacts) << c << label(step.active)
        << c << label(step.sweeps) << c << step.residual
        << c << step.worstOverlap << c << step.meanOverlap
        << c << step.maxVelocity
        << c << step.detectionTime + step.solutionTime;
}
