/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    grainDropletFoam

Group
    grpGrainSolvers

Description
    grainThermalFoam with droplets that evaporate among hot grains, take them in
    and dig themselves in (doc/theory, chapter 10).

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "pisoControl.H"

#include "adjustableTimeStep.H"
#include "buoyantPatches.H"
#include "carriedFields.H"
#include "coupledPatches.H"
#include "dictionaryInput.H"
#include "dropletLedger.H"
#include "fluidHeat.H"
#include "fluidInput.H"
#include "grainFluidExchange.H"
#include "grainFluidHeat.H"
#include "grainLedger.H"
#include "heatLedger.H"
#include "incompleteTimes.H"
#include "sigFpe.H"
#include "thermalFluid.H"
#include "vansFlow.H"
#include "vapour.H"
#include "vapourLedger.H"
#include "writtenStates.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Droplets that evaporate in a fluid with hot grains in contact."
    );

    #define CREATE_MESH createDynamicFvMesh.H
    #define CREATE_CONTROL createPiso.H
    #include "postProcess.H"

    #include "setRootCaseLists.H"

    setAsideIncompleteTimes(args);

    #include "createTime.H"
    #include "createDynamicFvMesh.H"

    #include "createPiso.H"

    #include "createFields.H"

    // What goes wrong is looked for and reported by name
    const sigFpe::ignore ignoreFpe;

    Info<< "\nStarting time loop\n" << endl;

    while (states.run())
    {
        carried.startStep();
        exchange.inject(fields.U);
        List<liquidDroplets::fate> fates;
        if (droplets.change(fates))
        {
            boiling.follow(fates);
            droplets.swell(term.inside());
            exchange.setEps();
            carried.makeRoom();
        }
        timeStep.set(flow.relativePhiU(), droplets.limits());
        ++runTime;

        ledger.startStep(flow.relativePhiU());

        if (mesh.dynamic())
        {
            flow.beforeMeshChange();
            carried.beforeMeshChange();
            heat.beforeMeshChange(carried.flux());
            steam.beforeMeshChange(carried.flux());
            if (mesh.update())
            {
                droplets.meshChanged();
                exchange.meshChanged();
                flow.meshChanged();
                heat.meshChanged(carried.flux());
                steam.meshChanged(carried.flux());
                fluid.correct();
                carried.meshChanged();
                ledger.meshChanged();
            }
        }

        heatBooks.startStep(carried.flux());
        term.followGrains();
        boiling.startStep(heat.T());
        droplets.lighten(boiling.lost());
        steam.tell(grains, exchange.eps());
        exchange.predict(fields.U);
        term.blow(boiling.jets(), boiling.growth(), fields.U);

        flow.setVolumeSource(boiling.volumeSource());
        flow.startStep();
        flow.predict(piso);
        while (piso.correct())
        {
            flow.correct(piso);
        }

        vectorField force, torque;
        term.forces(fields.U, flow.step().muf, force, torque);
        exchange.moveGrains(fields.U, flow.gradP(), flow.step().muf);
        exchange.addCrossing
        (
            droplets.move
            (
                force, torque, runTime.deltaTValue(),
                exchange.fields().freePatches
            )
        );
        const std::vector<bool> dried(droplets.shrink());
        droplets.swell(term.inside());
        exchange.setEps();
        boiling.keepGrowth();
        exchange.discharge(fields.U, fields.fluxesOfFluid());

        carried.carry
        (
            flow.fluidFlux(exchange.eps()),
            boiling.withVapour(exchange.filled())
        );
        heat.solve(carried.flux(), fields.U, fluid, heatExchange);
        boiling.carry(steam, carried.flux());

        // As a restart will find it
        fluid.correct();
        flow.densityChanged();

        ledger.endStep(fields.phi, fields.phiU);
        heatBooks.endStep(carried.flux());
        vapourBooks.endStep(carried.flux());
        dropletBooks.endStep(force);
        boiling.remove(droplets.remove(dried));
        grains.checkLost();
        droplets.checkLost();

        // Write times count from the last new mesh: the end need not be one
        const bool ends =
            runTime.value()
         >= runTime.endTime().value() - 0.5*runTime.deltaTValue();
        if (runTime.writeTime() || (mesh.dynamic() && ends))
        {
            states.write();
        }
    }

    Info<< "End\n" << endl;

    return 0;
}
