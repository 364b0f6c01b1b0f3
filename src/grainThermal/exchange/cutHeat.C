/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutHeat.H"

#include "Kader.H"
#include "Spalding.H"

Foam::cutHeat::cutHeat(const grainSystem& grains)
:
    grains_(grains),
    conduction_(grains)
{}


Foam::scalar Foam::cutHeat::throughLayer
(
    const cutCells::wall& x,
    const thermalFluid& fluid,
    const volVectorField& U
) const
{
    const label c = x.cell;
    const vector relative(U[c] - grains_.motion().motion(x.grain).at(x.arm));
    const scalar slip = mag(relative - (relative & x.normal)*x.normal);
    const scalar rho = fluid.rho()[c], mu = fluid.mu()[c];
    const scalar Re = rho*slip*x.distance/mu;
    const scalar Pr = fluid.capacity(c)/rho*mu/fluid.kappa()[c];
    return wallHeatRatio(sqrt(Re*wallShearRatio(Re)), Pr);
}


void Foam::cutHeat::add
(
    const boolList& isResolved,
    const volScalarField& T,
    const volScalarField& kappa,
    const thermalFluid& fluid,
    const volVectorField& U,
    cellHeat& cells
)
{
    conduction_.update(isResolved);
    cells.conductivity *= conduction_.part
    (
        T,
        [&](const label i) { return grains_.temperatures().temperature(i); }
    );

    tmp<volScalarField> withEddies;
    if (fluid.isTurbulent())
    {
        withEddies = fluid.kappaEff();
    }
    const scalarField& V = T.mesh().V();
    conductance_ = scalarField(grains_.overlaps().size(), Zero);
    for (const cutCells::wall& x : conduction_.cells().walls())
    {
        conductance_[x.overlap] = kappa[x.cell]*conduction_.perConductivity(x);
        if (withEddies.valid())
        {
            conductance_[x.overlap] *=
                fluid.kappa()[x.cell]/withEddies()[x.cell]
               *throughLayer(x, fluid, U);
        }
        cells.coefficient[x.cell] += conductance_[x.overlap]/V[x.cell];
    }
}
