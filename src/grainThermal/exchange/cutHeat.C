/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutHeat.H"


Foam::cutHeat::cutHeat(const grainSystem& grains)
:
    grains_(grains),
    conduction_(grains)
{}


void Foam::cutHeat::add
(
    const boolList& isResolved,
    const volScalarField& T,
    const volScalarField& kappa,
    cellHeat& cells
)
{
    conduction_.update(isResolved);
    cells.conductivity *= conduction_.part
    (
        T,
        [&](const label i) { return grains_.temperatures().temperature(i); }
    );

    const scalarField& V = T.mesh().V();
    conductance_ = scalarField(grains_.overlaps().size(), Zero);
    for (const cutCells::wall& x : conduction_.cells().walls())
    {
        conductance_[x.overlap] = kappa[x.cell]*conduction_.perConductivity(x);
        cells.coefficient[x.cell] += conductance_[x.overlap]/V[x.cell];
    }
}
