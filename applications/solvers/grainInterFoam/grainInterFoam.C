/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2017 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    grainInterFoam

Group
    grpGrainSolvers

Description
    Two immiscible incompressible fluids by the volume-of-fluid method, with
    immersed grains in contact that cross the surface between them
    (doc/theory, chapter 9).

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "pisoControl.H"

#include "adjustableTimeStep.H"
#include "carriedFields.H"
#include "coupledPatches.H"
#include "dictionaryInput.H"
#include "grainFluidExchange.H"
#include "grainLedger.H"
#include "incompleteTimes.H"
#include "liquidLedger.H"
#include "phaseFraction.H"
#include "sigFpe.H"
#include "twoFluidControls.H"
#include "vansFlow.H"
#include "waveInlets.H"
#include "writtenStates.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Two incompressible fluids with immersed grains in contact."
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
        const surfaceScalarField phiU(flow.relativePhiU());
        timeStep.set(phiU, surface.limits(phiU));
        ++runTime;

        ledger.startStep(phiU);

        if (mesh.dynamic())
        {
            flow.beforeMeshChange();
            carried.beforeMeshChange();
            phase.beforeMeshChange(carried.flux());
            if (mesh.update())
            {
                exchange.meshChanged();
                flow.meshChanged();
                phase.meshChanged
                (
                    carried.flux(), exchange.eps(),
                    exchange.resolved().locked()
                );
                carried.meshChanged();
                ledger.meshChanged();
            }
        }

        exchange.predict(fields.U);
        phase.pullOnGrains(exchange.resolved().locked());

        flow.startStep();
        flow.predict(piso);
        while (piso.correct())
        {
            flow.correct(piso);
        }

        exchange.moveGrains(fields.U, flow.gradP(), flow.step().muf);
        exchange.discharge(fields.U, fields.fluxesOfFluid());

        carried.carry
        (
            flow.fluidFlux(exchange.eps()), exchange.filled(), phase.gas()
        );
        phase.carry
        (
            carried.flux(), exchange.eps(), exchange.resolved().locked()
        );
        flow.densityChanged();

        ledger.endStep(fields.phi, fields.phiU);
        liquidBooks.endStep(fields.phiU);
        grains.checkLost();

        if (runTime.writeTime())
        {
            states.write();
        }
    }

    Info<< "End\n" << endl;

    return 0;
}
