/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompleteTimes.H"

#include "argList.H"
#include "caseDirectories.H"
#include "caseLock.H"
#include "meshFiles.H"
#include "OSspecific.H"
#include "Pstream.H"

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
        rmDir(aside, true);
        mv(timeDir, aside);
    }
}

// decomposePar makes none of a time without fields for ranks without grains
void makeDirectoriesOfRanks(const fileName& casePath)
{
    const fileNameList dirs(processorDirectories(casePath));

    for (const word& time : timesOnDisc(casePath))
    {
        bool divided = false;
        bool hasFields = false;
        for (const fileName& dir : dirs)
        {
            divided = divided || isDir(dir/time);
            hasFields =
                hasFields || !readDir(dir/time, fileName::FILE).empty();
        }

        if (divided && !hasFields)
        {
            for (const fileName& dir : dirs)
            {
                mkDir(dir/time);
            }
        }
    }
}

}


void Foam::setAsideIncompleteTimes(const argList& args)
{
    const fileName casePath(args.rootPath()/args.globalCaseName());

    // What a live run is writing is incomplete, too
    lockCase(args);
    refuseDamagedMeshFiles(args);

    wordList incomplete;
    if (Pstream::master())
    {
        for (const word& time : timesOnDisc(casePath))
        {
            if (isIncomplete(casePath/time))
            {
                incomplete.append(time);
            }
        }
    }
    Pstream::scatter(incomplete);

    for (const word& name : incomplete)
    {
        Info<< "Time " << name << " is incomplete; it is renamed to "
            << name << ".incomplete" << nl << endl;

        if (Pstream::master())
        {
            setAside(casePath/name);
            for (const fileName& dir : processorDirectories(casePath))
            {
                setAside(dir/name);
            }
        }
    }

    if (Pstream::parRun() && Pstream::master())
    {
        makeDirectoriesOfRanks(casePath);
    }

    // No rank looks for its start time before all is in order
    label nReady = 1;
    reduce(nReady, sumOp<label>());
}
