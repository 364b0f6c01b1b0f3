/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseDirectories.H"

#include "DynamicList.H"
#include "OSspecific.H"
#include "scalar.H"

Foam::wordList Foam::timesOnDisc(const fileName& casePath)
{
    DynamicList<word> times;
    for (const fileName& dir : readDir(casePath, fileName::DIRECTORY))
    {
        scalar value;
        if (readScalar(dir, value))
        {
            times.append(dir);
        }
    }
    return wordList(std::move(times));
}


Foam::fileNameList Foam::processorDirectories(const fileName& casePath)
{
    DynamicList<fileName> dirs;
    for (const fileName& dir : readDir(casePath, fileName::DIRECTORY))
    {
        if (dir.startsWith("processor"))
        {
            dirs.append(casePath/dir);
        }
    }
    return fileNameList(std::move(dirs));
}
