/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

#include "combineOverRanks.H"
#include "fvcGrad.H"

void Foam::grainFluidExchange::moveGrains
(
    const volVectorField& cellU,
    const volVectorField& cellGradP,
    const surfaceScalarField& mu
)
{
    const stopwatch::lap lap(time_);
    const tmp<volVectorField> tU(seenByGrains(cellU));
    const tmp<volVectorField> tGradP(seenByGrains(cellGradP));
    const volVectorField& U = tU();
    const volVectorField& gradP = tGradP();
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = mesh_.time().deltaTValue();
    const scalar rho = rho_.value();
    const vector& g = grains_.motion().g();
    const scalar onGrains = gradientOnGrains_;

    // For the torque, the fluid's velocity where the overlap is: a grain that
    // straddles two cells would take their difference for a spin
    const volTensorField gradU(fvc::grad(U));

    const vectorField& C = mesh_.C();

    vectorField force(grains_.size(), Zero);
    vectorField torque(grains_.size(), Zero);

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const scalar rhop = grains_.motion().density(graini);
        const bool isResolved = resolved_.isResolved(graini);
        const bool isCluster = grains_.members(graini).size() > 1;

        for
        (
            label k = overlaps.start[graini];
            k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            const scalar V = overlaps.volume[k];
            force[graini] -= V*rho*g;

            if (isResolved)
            {
                // The pressure on a disc or sphere has no moment
                if (isCluster)
                {
                    torque[graini] -= V*(overlaps.arm[k] ^ gradP[celli]);
                }
                continue;
            }

            const vector f
            (
                V
               *(
                  - onGrains*gradP[celli]
                  + gamma_[k]*a_[k]
                   *(U[celli] - vo_[k] + onGrains*deltaT/rhop*gradP[celli])
                  + e_[k]
                )
            );
            const vector fromCentre
            (
                overlaps.arm[k]
              - grains_.shortest(C[celli] - grains_.centres()[graini])
            );
            const vector shear
            (
                V*(gamma_[k] - dragOfAddedMass())*a_[k]
               *(fromCentre & gradU[celli])
            );
            force[graini] += f;
            torque[graini] += overlaps.arm[k] ^ (f + shear);
        }
    }
    addLockedForce(U, force);

    sumOverRanks(force);
    sumOverRanks(torque);
    resolved_.addTorque(U, mu, torque);

    // What the fluid's equation holds of the grains, cell by cell
    given_ = Zero;
    forAll(eps_, celli)
    {
        given_ += deltaT*mesh_.V()[celli]
           *(
              - (1 - eps_[celli])*rho*g
              + onGrains*(kappa_[celli] - 1 + fluidShare_[celli])
               *cellGradP[celli]
              + beta_[celli]*cellU[celli] - b_[celli]
            );
    }
    reduce(given_, sumOp<vector>());
    received_ = deltaT*sum(force);
    extendForce(force, torque);

    undisturbed_.keep(cellGradP);
    grains_.move(force, torque, deltaT);
    setEps();
}
