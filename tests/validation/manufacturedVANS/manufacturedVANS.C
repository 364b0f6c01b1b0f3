/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    manufacturedVANS

Description
    The momentum and pressure equations of grainFoam with grains whose share
    of the volume, drag and flux are prescribed such that the solution is
    known (exactSolution.H).  Prints the relative errors of U and p.

    The speed of the wave of the fluid fraction is 'waveSpeed' in
    system/controlDict, the form of the equations 'form', A or B.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "pisoControl.H"

#include "effectiveViscosity.H"
#include "exactSolution.H"
#include "prescribedGrains.H"
#include "timeScheme.H"

//- Root mean square over the volume
template<class Type>
static scalar rms(const fvMesh& mesh, const Field<Type>& values)
{
    return Foam::sqrt(gSum(mesh.V().field()*magSqr(values))/gSum(mesh.V().field()));
}


int main(int argc, char *argv[])
{
    #include "setRootCaseLists.H"
    #include "createTime.H"
    #include "createMesh.H"

    pisoControl piso(mesh);

    const dimensionedScalar rho("rho", dimDensity, 2);
    const dimensionedScalar mu("mu", dimPressure*dimTime, 0.1);
    const dimensionedScalar wallDrag("wallDrag", dimDensity/dimTime, 3);
    const autoPtr<effectiveViscosity> viscosity
    (
        effectiveViscosity::New(dictionary())
    );
    const exactSolution exact
    (
        rho.value(), mu.value(), wallDrag.value(),
        runTime.controlDict().get<scalar>("waveSpeed"),
        runTime.controlDict().get<word>("form") == "A"
    );
    prescribedGrains exchange(mesh, exact);
    prescribedGrains& grains = exchange;
    prescribedGrains& ledger = exchange;

    volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero)
    );
    volScalarField p_rgh
    (
        IOobject("p_rgh", runTime.timeName(), mesh),
        mesh,
        dimensionedScalar(dimPressure, Zero)
    );
    exchange.set(0);
    exchange.set(U, 0, &exactSolution::u);
    exchange.set(p_rgh, 0, &exactSolution::p);

    surfaceScalarField phiU("phiU", fvc::flux(U));
    surfaceScalarField phiAlpha
    (
        "phiAlpha", fvc::flux((exchange.fluidShare() + exchange.kappa())*U)
    );
    surfaceScalarField phi("phi", phiAlpha + fvc::flux(exchange.G()));

    const volScalarField gh("gh", 0*p_rgh/rho);
    volScalarField p("p", p_rgh);
    label pRefCell = 0;
    scalar pRefValue = 0;
    mesh.setFluxRequired(p_rgh.name());

    while (runTime.loop())
    {
        exchange.set(runTime.value());

        #include "UEqn.H"

        volVectorField gradP("gradP", pressureForce/share);

        while (piso.correct())
        {
            #include "pEqn.H"
        }
    }

    volVectorField exactU(U);
    volScalarField exactP(p);
    exchange.set(exactU, runTime.value(), &exactSolution::u);
    exchange.set(exactP, runTime.value(), &exactSolution::p);
    scalarField difference(p.primitiveField() - exactP.primitiveField());
    difference -= gSum(difference*mesh.V().field())/gSum(mesh.V().field());

    Info<< "Error of U "
        << rms(mesh, vectorField(U - exactU))/rms(mesh, exactU.primitiveField())
        << ", of p "
        << rms(mesh, difference)/rms(mesh, exactP.primitiveField()) << nl
        << "End" << endl;

    return 0;
}
