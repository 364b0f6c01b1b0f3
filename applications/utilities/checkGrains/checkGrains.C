/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    checkGrains

Group
    grpGrainPreProcessing

Description
    What checkMesh is to a mesh: number and sizes of grains, overlaps, packing
    fraction, grains outside the mesh, cell size over diameter, how the flow about
    grains comes about, and the time step that is recommended, with the reason.
    Of grains with heat in a fluid with heat, their Biot numbers.

    The grains are those of grains.h5 in the start time if there is one, else
    the initial grains of constant/grainProperties.  They are in a fluid if
    there is a file constant/transportProperties.  Returns 1 if the solver
    would refuse them.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"

#include "dictionaryInput.H"
#include "BiotNumbers.H"
#include "dragLaw.H"
#include "effectiveConductivity.H"
#include "flowRegimes.H"
#include "fluidInput.H"
#include "functionOfTemperature.H"
#include "grainChecks.H"
#include "grainState.H"
#include "packingReport.H"
#include "passablePatches.H"
#include "recommendedTimeStep.H"
#include "thermalFluid.H"
#include "twoFluidControls.H"
#include "twoFluids.H"

// Grains, and the bodies of walls that move, where they are
template<int D>
struct grainsAndWalls
{
    nscd::Grains<D> grains;
    std::vector<nscd::WallBody<D>> bodies;
    bool areOfState;
};


// The state at the start time or the initial grains
template<int D>
grainsAndWalls<D> readState(const grainProperties<D>& properties)
{
    const Time& runTime = properties.space().mesh().time();
    const fileName state(grainStateFile(runTime));
    if (!continuesFromState(runTime))
    {
        Info<< "Initial grains of constant/grainProperties" << nl;
        return {properties.initialGrains(), properties.walls().bodies(), false};
    }

    nscd::ContactDynamics<D> dynamics
    (
        nscd::Grains<D>(), properties.walls().walls(),
        properties.materials().contactTable(), properties.contact(),
        MPI_COMM_WORLD, properties.walls().bodies()
    );
    dynamics.setWallNames(properties.walls().names());
    dynamics.load(state);
    Info<< "Grains of " << state << nl;
    return {dynamics.grains(), dynamics.wallBodies(), true};
}


template<int D>
void printTimeStepInFluid
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const dictionary& transport
)
{
    if (transport.found("phases"))
    {
        for (const word& phase : transport.get<wordList>("phases"))
        {
            Info<< nl << "In " << phase << ':' << nl;
            printTimeStepInFluid(properties, grains, transport.subDict(phase));
        }
        return;
    }
    const autoPtr<dragLaw> drag
    (
        dragLaw::New
        (
            dictionaryInput::subDict(properties.coupling(), "drag"), D
        )
    );
    const scalar rho =
        dictionaryInput::getPositive(transport, "rho", dimDensity);
    const scalar T = meanTemperature(grains);
    const scalar mu =
        transport.found("mu")
      ? functionOfTemperature(transport, "mu", dimDynamicViscosity).at(T)
      : rho*dictionaryInput::getPositive(transport, "nu", dimViscosity);

    const List<settling> alone
    (
        settlingAlone(properties, grains, *drag, rho, mu)
    );
    printFlowRegimes
    (
        properties.coupling(), alone,
        properties.space().cellSizeRange().first(), D == 3
    );
    printTimeStep(properties, grains, alone);
    // Fatal for what solvers refuse
    effectiveConductivity::New(properties.coupling(), D, "diffusivity");
    if (properties.dict().found("heat"))
    {
        effectiveConductivity::New(properties.coupling(), D);
        printBiotNumbers(properties, grains, alone, transport, mu);
    }
}


// False if a solver would refuse the grains
template<int D>
bool check(const fvMesh& mesh, const dictionary& transport)
{
    const grainProperties<D> properties
    (
        mesh, meshObjects::gravity::New(mesh.time()).value()
    );
    grainsAndWalls<D> state(readState(properties));
    nscd::Grains<D>& grains = state.grains;
    grainChecks<D>(properties, grains).requireTolerance();
    for (nscd::Vector<D>& x : grains.position)
    {
        x = properties.wrapped(x);
    }

    printWalls(properties, state.bodies);
    if (!properties.areFixed())
    {
        refuseMirrors(properties.dict(), mesh);
    }
    printPassablePatches(properties.dict(), mesh);
    printPacking(properties, grains);
    const bool good =
        printFaults(properties, grains, state.bodies, state.areOfState);

    if
    (
        grains.size()
     && (
            transport.found("nu") || transport.found("mu")
         || transport.found("phases")
        )
    )
    {
        printTimeStepInFluid(properties, grains, transport);
    }
    else if (grains.size())
    {
        printTimeStep(properties, grains);
    }
    return good;
}


int main(int argc, char *argv[])
{
    argList::addNote("Check grains, their packing and their size.");
    argList::noParallel();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    // Empty for dry grains
    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties",
            runTime.constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        )
    );
    if (transport.found("phases"))
    {
        twoFluids::check(mesh);
        checkTwoFluidControls(mesh);
    }
    else if (transport.size())
    {
        checkFluidInput
        (
            mesh,
            transport,
            transport.found("Cp") ? thermalFluid::keywords() : wordList()
        );
    }
    const bool good =
        isPlanar(mesh) ? check<2>(mesh, transport) : check<3>(mesh, transport);

    Info<< nl << (good ? "Grains OK." : "Failed: see above.") << nl
        << nl << "End" << nl << endl;

    if (!good)
    {
        // argList's destructor would return 0
        Pstream::exit(1);
    }
    return 0;
}
