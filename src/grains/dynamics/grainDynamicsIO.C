/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "caseDirectories.H"
#include "grainState.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <algorithm>

namespace
{

//- Are its files all states of grains, injections, outlets or others that move beside
//  them?
bool holdsStatesOnly(const Foam::fileName& timeDir)
{
    const Foam::fileNameList files(readDir(timeDir, Foam::fileName::FILE));
    return std::all_of
    (
        files.begin(), files.end(),
        [](const Foam::fileName& file)
        {
            return
                file == "injections"
             || file.lessExt() == "outlets"
             || file.ext() == "h5";
        }
    );
}

}


template<int D>
Foam::fileName Foam::grainDynamics<D>::stateFile() const
{
    return grainStateFile(mesh().time(), name_);
}


template<int D>
void Foam::grainDynamics<D>::save(const word& suffix) const
{
    const fileName file(stateFile());
    if (Pstream::master())
    {
        mkDir(file.path());
        rm(file);
    }
    try
    {
        dynamics_->save(file + suffix, mesh().time().value());
    }
    catch (const std::exception& err)
    {
        FatalErrorInFunction
            << "The state of the grains could not be written: " << err.what()
            << exit(FatalError);
    }
}


template<int D>
bool Foam::grainDynamics<D>::writeContactProblem(const fileName& file) const
{
    if (!lastStep_.contacts || size() != sizeOfStep_)
    {
        return false;
    }
    try
    {
        dynamics_->dumpContactProblem(file);
    }
    catch (const std::exception& err)
    {
        FatalErrorInFunction
            << "The contact problem could not be written: " << err.what()
            << exit(FatalError);
    }
    return true;
}


template<int D>
void Foam::grainDynamics<D>::beginWrite() const
{
    save(".incomplete");
    injections_.save(stateFile().path()/"injections");
    outlets_.save(stateFile().path());
}


template<int D>
void Foam::grainDynamics<D>::endWrite() const
{
    writeCloud();

    // All ranks have written their fields
    label nReady = 1;
    reduce(nReady, sumOp<label>());

    if (Pstream::master())
    {
        mv(stateFile() + ".incomplete", stateFile());
        purge();
    }
}


template<int D>
void Foam::grainDynamics<D>::purge() const
{
    const Time& runTime = mesh().time();
    if
    (
        !Pstream::parRun()
     || runTime.controlDict().getOrDefault<label>("purgeWrite", 0) <= 0
    )
    {
        return;
    }

    // The fields of the ranks have been purged by Time, in their directories
    const fileName casePath(runTime.globalPath());
    const fileNameList processors(processorDirectories(casePath));
    for (const word& time : timesOnDisc(casePath))
    {
        const fileName timeDir(casePath/time);
        const bool hasFields = std::any_of
        (
            processors.begin(), processors.end(),
            [&](const fileName& dir) { return isDir(dir/time); }
        );
        if
        (
            !hasFields
         && isFile(timeDir/"grains.h5", false)
         && holdsStatesOnly(timeDir)
         && readDir(timeDir, fileName::DIRECTORY).empty()
        )
        {
            rmDir(timeDir);
        }
    }
}


template Foam::fileName Foam::grainDynamics<2>::stateFile() const;
template Foam::fileName Foam::grainDynamics<3>::stateFile() const;
template void Foam::grainDynamics<2>::save(const Foam::word&) const;
template void Foam::grainDynamics<3>::save(const Foam::word&) const;
template void Foam::grainDynamics<2>::beginWrite() const;
template void Foam::grainDynamics<3>::beginWrite() const;
template void Foam::grainDynamics<2>::endWrite() const;
template void Foam::grainDynamics<3>::endWrite() const;
template bool Foam::grainDynamics<2>::writeContactProblem
(
    const fileName&
) const;
template bool Foam::grainDynamics<3>::writeContactProblem
(
    const fileName&
) const;
