/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    dryGrainFoam

Group
    grpGrainSolvers

Description
    Dynamics of dry grains in contact and conduction of heat between them:
    discs on a mesh that is one cell thick, spheres on any other; non-smooth
    contact dynamics (doc/theory/contacts.md).  The mesh has patches that can be walls,
    and tells where grains may be.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "sigFpe.H"

#include "dictionaryInput.H"
#include "dryLedger.H"
#include "dryTimeStep.H"
#include "fluidInput.H"
#include "incompleteTimes.H"
#include "writtenStates.H"

template<int D>
void run(Time& runTime, const fvMesh& mesh, const vector& g)
{
    grainDynamics<D> grains(mesh, g);
    dryTimeStep timeStep(runTime, grains, g);

    // What goes wrong is looked for and reported by name
    const sigFpe::ignore ignoreFpe;

    dryLedger<D> ledger(grains);
    writtenStates states(runTime, {&grains});

    Info<< "\nStarting time loop\n" << endl;

    while (states.run())
    {
        grains.inject(nullptr);
        timeStep.set();
        ++runTime;

        ledger.startStep();

        grains.move(runTime.deltaTValue());
        grains.conduct(runTime.deltaTValue());
        grains.discharge();

        ledger.endStep();
        grains.checkInside();

        if (runTime.writeTime())
        {
            states.write();
        }
    }
}


int main(int argc, char *argv[])
{
    argList::addNote("Dynamics of dry grains in contact.");

    #define NO_CONTROL
    #define CREATE_FIELDS createGrains.H
    #include "postProcess.H"

    #include "setRootCaseLists.H"

    setAsideIncompleteTimes(args);

    #include "createTime.H"
    #include "createMesh.H"

    refuseFiles(runTime, {"dynamicMeshDict"});

    #include "readGravitationalAcceleration.H"
    dictionaryInput::checkDimensions
    (
        static_cast<const uniformDimensionedVectorField&>(g),
        g.dimensions(),
        dimAcceleration
    );

    if (isPlanar(mesh))
    {
        run<2>(runTime, mesh, g.value());
    }
    else
    {
        run<3>(runTime, mesh, g.value());
    }

    Info<< "End\n" << endl;

    return 0;
}
