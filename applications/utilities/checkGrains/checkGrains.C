/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    checkGrains

Group
    grpGrainPreProcessing

Description
    What checkMesh is to a mesh: number and sizes of grains, overlaps, packing
    fraction, grains outside the mesh, cell size over diameter, and the time
    step that is recommended, with the reason.

    The grains are those of grains.h5 in the start time if there is one, else
    the initial grains of constant/grainProperties.  Returns 1 if the solver
    would refuse them.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "OSspecific.H"

#include "dictionaryInput.H"
#include "dragLaw.H"
#include "grainChecks.H"
#include "packingReport.H"
#include "recommendedTimeStep.H"

int main(int argc, char *argv[])
{
    argList::addNote("Check grains, their packing and their size.");
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const grainProperties properties
    (
        mesh, meshObjects::gravity::New(runTime).value()
    );
    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );
    const scalar rho =
        dictionaryInput::getPositive(transport, "rho", dimDensity);
    const scalar nu =
        dictionaryInput::getPositive(transport, "nu", dimViscosity);

    const fileName state(runTime.timePath()/"grains.h5");
    nscd::Grains<2> grains;
    if (isFile(state, false))
    {
        nscd::ContactDynamics<2> dynamics
        (
            grains, properties.walls(),
            properties.materials().contactTable(), properties.contact()
        );
        dynamics.load(state);
        grains = dynamics.grains();
        Info<< "Grains of " << state << nl;
    }
    else
    {
        grains = properties.initialGrains();
        Info<< "Initial grains of constant/grainProperties" << nl;
    }

    printPacking(properties, grains);
    const bool good = printFaults(properties, grains);

    if (grains.size())
    {
        const autoPtr<dragLaw> drag
        (
            dragLaw::New
            (
                dictionaryInput::subDict(properties.coupling(), "drag")
            )
        );
        printTimeStep(properties, grains, *drag, rho, rho*nu);
    }

    Info<< nl << (good ? "Grains OK." : "Failed: see above.") << nl
        << nl << "End" << nl << endl;

    if (!good)
    {
        // argList's destructor would return 0
        Pstream::exit(1);
    }
    return 0;
}
