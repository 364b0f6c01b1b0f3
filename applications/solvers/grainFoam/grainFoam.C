/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    grainFoam

Group
    grpGrainSolvers

Description
    Transient solver for an incompressible fluid, laminar or turbulent, with
    immersed grains in contact: volume-averaged Navier-Stokes equations,
    semi-implicit exchange over the overlaps of grains and cells, non-smooth
    contact dynamics (doc/theory).  PISO algorithm.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "pisoControl.H"

#include "adjustableTimeStep.H"
#include "carriedFields.H"
#include "coupledPatches.H"
#include "dictionaryInput.H"
#include "fluidInput.H"
#include "grainFluidExchange.H"
#include "grainLedger.H"
#include "incompleteTimes.H"
#include "sigFpe.H"
#include "singleFluid.H"
#include "vansFlow.H"
#include "writtenStates.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Incompressible flow with immersed grains in contact."
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
            if (mesh.update())
            {
                exchange.meshChanged();
                flow.meshChanged();
                carried.meshChanged();
                ledger.meshChanged();
            }
        }

        exchange.predict(fields.U);
        fluid.correct();

        flow.startStep();
        flow.predict(piso);
        while (piso.correct())
        {
            flow.correct(piso);
        }

        exchange.moveGrains(fields.U, flow.gradP(), flow.step().muf);
        exchange.discharge(fields.U, fields.fluxesOfFluid());

        const bool isStirred = exchange.fields().isStirred();
        carried.setStirred(isStirred);
        if (carried.isActive() || isStirred)
        {
            carried.carry(flow.fluidFlux(exchange.eps()), exchange.filled());
        }
        else
        {
            carried.skip();
        }

        ledger.endStep(fields.phi, fields.phiU);
        grains.checkLost();

        if (runTime.writeTime())
        {
            states.write();
        }
    }

    Info<< "End\n" << endl;

    return 0;
}
