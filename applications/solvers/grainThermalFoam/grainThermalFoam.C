/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    grainThermalFoam

Group
    grpGrainSolvers

Description
    grainFoam with heat: fluid and grains exchange it over their overlaps,
    grains conduct it through their contacts, the fluid is driven by its
    weight in Boussinesq's approximation (doc/theory, chapter 8).

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "pisoControl.H"

#include "adjustableTimeStep.H"
#include "buoyantPatches.H"
#include "carriedFields.H"
#include "coupledPatches.H"
#include "dictionaryInput.H"
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
        "Incompressible flow and heat with immersed grains in contact."
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
        timeStep.set(flow.relativePhiU());
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
        steam.tell(grains, exchange.eps());
        exchange.predict(fields.U);

        flow.startStep();
        flow.predict(piso);
        while (piso.correct())
        {
            flow.correct(piso);
        }

        exchange.moveGrains(fields.U, flow.gradP(), flow.step().muf);
        exchange.discharge(fields.U, fields.fluxesOfFluid());

        carried.carry(flow.fluidFlux(exchange.eps()), exchange.filled());
        heat.solve(carried.flux(), fields.U, fluid, heatExchange);
        steam.carry(carried.flux());

        // As a restart will find it
        fluid.correct();
        flow.densityChanged();

        ledger.endStep(fields.phi, fields.phiU);
        heatBooks.endStep(carried.flux());
        vapourBooks.endStep(carried.flux());
        grains.checkLost();

        if (runTime.writeTime())
        {
            states.write();
        }
    }

    Info<< "End\n" << endl;

    return 0;
}
