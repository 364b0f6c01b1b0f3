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
    Transient solver for an incompressible, laminar Newtonian fluid with
    immersed grains in contact: volume-averaged Navier-Stokes equations,
    semi-implicit exchange over the overlaps of grains and cells, non-smooth
    contact dynamics (doc/theory.md).  PISO algorithm.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "pisoControl.H"

#include "adjustableTimeStep.H"
#include "dictionaryInput.H"
#include "effectiveViscosity.H"
#include "grainFluidExchange.H"
#include "grainLedger.H"
#include "HeleShaw.H"
#include "incompleteTimes.H"
#include "missingFields.H"
#include "sigFpe.H"
#include "timeScheme.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Incompressible laminar flow with immersed grains in contact."
    );

    #include "setRootCaseLists.H"

    setAsideIncompleteTimes(args);

    #include "createTime.H"
    #include "createMesh.H"

    pisoControl piso(mesh);

    #include "createFields.H"

    // What goes wrong is looked for and reported by name
    const sigFpe::ignore ignoreFpe;

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        exchange.inject(U);
        timeStep.set(phiU);
        ++runTime;

        ledger.startStep(phiU);

        exchange.predict(U);

        #include "UEqn.H"

        volVectorField gradP("gradP", pressureForce/share);

        while (piso.correct())
        {
            #include "pEqn.H"
        }

        ledger.checkFinite(U, p_rgh);

        exchange.moveGrains(U, gradP, muf);
        exchange.discharge(U, phiU);

        ledger.endStep(phi, phiU);
        grains.checkLost();

        #include "write.H"
    }

    Info<< "End\n" << endl;

    return 0;
}
