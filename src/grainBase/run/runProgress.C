/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runProgress.H"

#include "OSspecific.H"
#include "Pstream.H"

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


Foam::runProgress::runProgress(const Time& runTime)
:
    time_(runTime),
    startTime_(runTime.value())
{}


void Foam::runProgress::print(const string& shares) const
{
    const scalar done = time_.value() - startTime_;
    const scalar toDo = time_.endTime().value() - time_.value();

    Info<< "Elapsed   " << duration(elapsed()).c_str() << shares.c_str() << ", about "
        << duration(elapsed()/max(done, VSMALL)*max(toDo, 0.0)).c_str()
        << " to go" << nl;
    time_.printExecutionTime(Info);
}


Foam::autoPtr<Foam::OFstream> Foam::runProgress::newFile
(
    const word& name,
    const word& file,
    const char* header
) const
{
    autoPtr<OFstream> result;
    if (Pstream::master())
    {
        const fileName dir
        (
            time_.globalPath()/"postProcessing"/name/Time::timeName(startTime_)
        );
        mkDir(dir);
        result.reset(new OFstream(dir/file));
        result().precision(12);
        result() << header << nl;
    }
    return result;
}
