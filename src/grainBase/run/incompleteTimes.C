/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompleteTimes.H"

#include "argList.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "TimePaths.H"

namespace
{

using namespace Foam;

bool isIncomplete(const fileName& timeDir)
{
    const fileNameList files(readDir(timeDir, fileName::FILE));
    for (const fileName& file : files)
    {
        if (file.startsWith("grains.h5."))
        {
            return true;
        }
    }
    return files.empty() && readDir(timeDir, fileName::DIRECTORY).empty();
}

void setAside(const fileName& timeDir)
{
    if (isDir(timeDir))
    {
        const fileName aside(timeDir + ".incomplete");
        rmDir(aside);
        mv(timeDir, aside);
    }
}

}


void Foam::setAsideIncompleteTimes(const argList& args)
{
    const fileName casePath(args.rootPath()/args.globalCaseName());

    wordList incomplete;
    if (Pstream::master())
    {
        for (const instant& time : TimePaths::findTimes(casePath))
        {
            if (isIncomplete(casePath/time.name()))
            {
                incomplete.append(time.name());
            }
        }
    }
    Pstream::scatter(incomplete);

    for (const word& name : incomplete)
    {
        Info<< "Time " << name << " is incomplete; it is renamed to "
            << name << ".incomplete" << nl << endl;

        setAside(casePath/name);
        for (const fileName& dir : readDir(casePath, fileName::DIRECTORY))
        {
            if (Pstream::master() && dir.startsWith("processor"))
            {
                setAside(casePath/dir/name);
            }
        }
    }

    // No rank looks for its start time before all is in order
    label nReady = 1;
    reduce(nReady, sumOp<label>());
}
