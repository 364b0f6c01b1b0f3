/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

void Foam::grainFluidExchange::moveGrains
(
    const volVectorField& U,
    const volVectorField& gradP
)
{
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = mesh_.time().deltaTValue();
    const scalar rho = rho_.value();

    vectorField force(grains_.size(), Zero);
    vectorField torque(grains_.size(), Zero);
    scalarField phi(mesh_.nCells(), Zero);

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const scalar rhop = grains_.density(graini);

        for
        (
            label k = overlaps.start[graini];
            k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            const vector f
            (
                overlaps.volume[k]
               *(
                  - gradP[celli] - rho*grains_.properties().g()
                  + gamma_[k]*a_[k]
                   *(U[celli] - vo_[k] + deltaT/rhop*gradP[celli])
                )
            );
            force[graini] += f;
            torque[graini] += overlaps.arm[k] ^ f;
            phi[celli] += overlaps.volume[k]/mesh_.V()[celli];
        }
    }
    Pstream::listCombineGather(force, plusEqOp<vector>());
    Pstream::listCombineScatter(force);
    Pstream::listCombineGather(torque, plusEqOp<vector>());
    Pstream::listCombineScatter(torque);

    // What the fluid's equation holds of the grains, cell by cell
    given_ = Zero;
    forAll(phi, celli)
    {
        given_ += deltaT*mesh_.V()[celli]
           *(
              - phi[celli]*rho*grains_.properties().g()
              + (kappa_[celli] - phi[celli])*gradP[celli]
              + beta_[celli]*U[celli] - b_[celli]
            );
    }
    reduce(given_, sumOp<vector>());
    received_ = deltaT*sum(force);

    grains_.move(force, torque, deltaT);
    setEps();
}
