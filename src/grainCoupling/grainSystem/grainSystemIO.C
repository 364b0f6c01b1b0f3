/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainSystem.H"

#include "IOField.H"
#include "OSspecific.H"
#include "passiveParticleCloud.H"
#include "Pstream.H"

Foam::fileName Foam::grainSystem::stateFile() const
{
    const Time& runTime = mesh().time();
    return runTime.globalPath()/runTime.timeName()/"grains.h5";
}


void Foam::grainSystem::beginWrite() const
{
    const fileName file(stateFile());
    if (Pstream::master())
    {
        mkDir(file.path());
        rm(file);
    }
    try
    {
        dynamics_->save(file + ".incomplete", mesh().time().value());
    }
    catch (const std::exception& err)
    {
        FatalErrorInFunction
            << "The state of the grains could not be written: " << err.what()
            << exit(FatalError);
    }
}


void Foam::grainSystem::endWrite() const
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


void Foam::grainSystem::purge() const
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
    for (const instant& time : Time::findTimes(casePath))
    {
        const fileName timeDir(casePath/time.name());
        if
        (
            !isDir(runTime.path()/time.name())
         && isFile(timeDir/"grains.h5", false)
         && readDir(timeDir, fileName::FILE).size() == 1
         && readDir(timeDir, fileName::DIRECTORY).empty()
        )
        {
            rmDir(timeDir);
        }
    }
}


void Foam::grainSystem::writeCloud() const
{
    const nscd::Grains<2>& grains = dynamics_->grains();

    // Also the positions that older readers look for
    particle::writeLagrangianPositions = true;

    passiveParticleCloud cloud
    (
        mesh(), "grains", IDLList<passiveParticle>()
    );
    DynamicList<label> local;
    forAll(centre_, i)
    {
        const label celli = plane().findCell(grains.position[i]);
        if (celli >= 0)
        {
            passiveParticle* grain =
                new passiveParticle(mesh(), centre_[i], celli);
            grain->origId() = grains.id[i];
            cloud.addParticle(grain);
            local.append(i);
        }
    }
    cloud.write();

    const auto writeField = [&](const word& name, const auto& value)
    {
        typedef typename std::decay<decltype(value(0))>::type Type;
        IOField<Type> field
        (
            cloud.fieldIOobject(name, IOobject::NO_READ), local.size()
        );
        forAll(local, k)
        {
            field[k] = value(local[k]);
        }
        field.write(local.size());
    };

    writeField("radius", [&](label i) { return scalar(grains.radius[i]); });
    writeField("mass", [&](label i) { return scalar(grains.mass[i]); });
    writeField("U", [&](label i) { return velocity(i, Zero); });
    writeField
    (
        "omega",
        [&](label i) { return plane().spinInSpace(grains.spin[i][0]); }
    );
    writeField("fluidForce", [&](label i) { return fluidForce_[i]; });
    writeField("material", [&](label i) { return label(grains.material[i]); });
    writeField
    (
        "temperature", [&](label i) { return scalar(grains.temperature[i]); }
    );
}
