/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidHeat.H"

#include "dictionaryInput.H"

Foam::fluidHeat::fluidHeat(const fvMesh& mesh)
:
    T_(mesh, "T"),
    plates_(0)
{
    const volScalarField& T = T_.field();
    dictionaryInput::checkDimensions(T, T.dimensions(), dimTemperature);
    checkPositive("internalField", T.primitiveField());
    for (const fvPatchScalarField& patch : T.boundaryField())
    {
        checkPositive("boundaryField." + patch.patch().name(), patch);
    }
}


void Foam::fluidHeat::checkPositive
(
    const string& keyword,
    const scalarField& T
) const
{
    const scalar least = min(T), most = max(T);
    if (T.size() && !(least > 0 && most <= GREAT))
    {
        FatalErrorInFunction
            << "Keyword '" << keyword.c_str() << "' of the file "
            << T_.field().objectPath() << " has the value "
            << (least > 0 ? most : least) << nl
            << "    allowed: values > 0 [K] and at most " << GREAT
            << exit(FatalError);
    }
}


void Foam::fluidHeat::solve
(
    const transportFlux& flux,
    const volVectorField& U,
    const thermalFluid& fluid,
    grainFluidHeat& exchange
)
{
    const volScalarField& T = T_.field();
    const fvMesh& mesh = T.mesh();
    const scalarField& V = mesh.V().field();
    const scalar deltaT = mesh.time().deltaTValue();
    const scalar C = fluid.capacity();

    const cellHeat cells(exchange.cells(T, U));
    T_.carry
    (
        flux,
        cells.conductivity
       /dimensionedScalar
        (
            "C", cells.conductivity.dimensions()/dimViscosity, C
        ),
        cells.perCapacity(C),
        exchange.bodies()
    );

    const plateHeat& plates = fluid.plates();
    plates_ =
        deltaT*plates.coefficient()
       *gSum(V*(plates.temperature() - T.primitiveField()));

    exchange.give(T);
}
