/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    manufacturedVANS

Description
    The momentum and pressure equations of grainFoam, and a scalar that the
    fluid carries, with grains whose share of the volume, drag and flux are
    prescribed such that the solution is known (exactSolution.H).  Prints the
    relative errors of U, p and T.

    The speed of the wave of the fluid fraction is 'waveSpeed' in
    system/controlDict, the form of the equations 'form', A or B.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "pisoControl.H"

#include "fluidScalar.H"
#include "noResolvedTerm.H"
#include "prescribedExchange.H"
#include "prescribedFluid.H"
#include "vansFlow.H"

//- Root mean square over the volume
template<class Type>
static scalar rms(const fvMesh& mesh, const Field<Type>& values)
{
    return Foam::sqrt(gSum(mesh.V().field()*magSqr(values))/gSum(mesh.V().field()));
}


//- Write a field of the start, as a case has them
template<class Type>
static void writeInitial
(
    const fvMesh& mesh,
    const prescribedExchange& exchange,
    const word& name,
    const dimensionSet& dims,
    Type (exactSolution::*value)(const vector&, const scalar) const
)
{
    GeometricField<Type, fvPatchField, volMesh> field
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensioned<Type>(dims, Zero)
    );
    exchange.set(field, 0, value);
    field.write();
}


int main(int argc, char *argv[])
{
    #include "setRootCaseLists.H"
    #include "createTime.H"
    #include "createMesh.H"

    const scalar rho = 2, mu = 0.1, wallDrag = 3;
    const exactSolution exact
    (
        rho, mu, wallDrag,
        runTime.controlDict().get<scalar>("waveSpeed"),
        runTime.controlDict().get<word>("form") == "A"
    );
    prescribedExchange exchange(mesh, exact);
    exchange.set(0);
    writeInitial(mesh, exchange, "U", dimVelocity, &exactSolution::u);
    writeInitial(mesh, exchange, "p_rgh", dimPressure, &exactSolution::p);
    writeInitial(mesh, exchange, "T", dimless, &exactSolution::T);

    pisoControl piso(mesh);
    const prescribedFluid fluid(mesh, rho, mu, wallDrag);
    const autoPtr<effectiveViscosity> viscosity
    (
        effectiveViscosity::New(dictionary())
    );
    noResolvedTerm resolved(mesh);

    vansFields fields(mesh);
    const volScalarField& eps = exchange.fields.fluidShare;
    fields.phi =
        fvc::flux
        (
            (eps + exchange.fields.kappa)*fields.U + exchange.fields.G
        );
    vansFlow flow
    (
        fields, fluid, viscosity(), exchange.fields, resolved,
        dimensionedVector("g", dimAcceleration, Zero), piso.dict()
    );

    transportFlux flux(eps, fvc::flux(eps*fields.U), fields.p_rgh);
    const dimensionedScalar D("D", dimViscosity, exactSolution::D);
    fluidScalar T(mesh, "T");

    while (runTime.loop())
    {
        flux.startStep();
        exchange.set(runTime.value());

        flow.startStep();
        flow.predict(piso);
        while (piso.correct())
        {
            flow.correct(piso);
        }

        flux.set(flow.fluidFlux(eps), scalarField(mesh.nCells(), Zero));
        scalarField source(mesh.nCells());
        forAll(source, celli)
        {
            source[celli] = exact.sourceOfT
            (
                mesh.C()[celli], runTime.value() - 0.5*runTime.deltaTValue()
            );
        }
        T.carry(flux, D*fvc::interpolate(flux.fraction()), {{}, source});
    }

    volVectorField exactU("exactU", fields.U);
    volScalarField exactP("exactP", fields.p_rgh);
    volScalarField exactT("exactT", T.field());
    exchange.set(exactU, runTime.value(), &exactSolution::u);
    exchange.set(exactP, runTime.value(), &exactSolution::p);
    exchange.set(exactT, runTime.value(), &exactSolution::T);
    scalarField difference(fields.p_rgh.primitiveField() - exactP.primitiveField());
    difference -= gSum(difference*mesh.V().field())/gSum(mesh.V().field());

    Info<< "Error of U "
        << rms(mesh, vectorField(fields.U - exactU))/rms(mesh, exactU.primitiveField())
        << ", of p "
        << rms(mesh, difference)/rms(mesh, exactP.primitiveField())
        << ", of T "
        << rms(mesh, scalarField(T.field() - exactT))/rms(mesh, exactT.primitiveField())
        << ", defect of the flux " << flux.defect() << nl
        << "End" << endl;

    return 0;
}
