/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "fvcSnGrad.H"
#include "meanOverGrains.H"

void Foam::resolvedGrains::addTorque
(
    const volVectorField& U,
    const surfaceScalarField& mu,
    vectorField& torque
) const
{
    if (!isActive_)
    {
        return;
    }

    const surfaceScalarField perLength(mu*mesh_.magSf());
    const surfaceVectorField flux
    (
        perLength
       *(
            conductance_*fvc::snGrad(U)
          + mesh_.nonOrthDeltaCoeffs()*wallJump_
        )
    );
    const surfaceScalarField perSpeed
    (
        perLength*conductance_*mesh_.nonOrthDeltaCoeffs()
    );

    // Torque of each grain, and how much less it would be per spin
    vectorField viscous(grains_.size(), Zero);
    scalarField resistance(grains_.size(), Zero);

    forLinks
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label patchi,
            const label facei
        )
        {
            // A coupled face belongs to the rank of the grain's cell
            if
            (
                own.isLocked() == nei.isLocked()
             || (patchi >= 0 && !own.isLocked())
            )
            {
                return;
            }
            const side& inGrain = own.isLocked() ? own : nei;
            const side& inFluid = own.isLocked() ? nei : own;
            const vector f
            (
                (own.isLocked() ? 1 : -1)*resolvedFace::at(flux, patchi, facei)
            );
            const label graini = label(inGrain.grain);
            const vector arm
            (
                between(grains_.centres()[graini], inFluid.x)
              + inMesh(inGrain.x - inFluid.x)
               /resolvedFace::at(conductance_, patchi, facei)
            );
            viscous[graini] += arm ^ f;
            resistance[graini] +=
                resolvedFace::at(perSpeed, patchi, facei)*magSqr(arm);
        }
    );
    sumOverRanks(viscous);
    sumOverRanks(resistance);

    const scalarField grainMu(meanOverGrains(grains_, fluid_.mu()));
    const scalar squaredGyration = mesh_.nGeometricD() == 3 ? 0.1 : 0.125;
    forAll(torque, graini)
    {
        if (!isResolved_[graini])
        {
            continue;
        }
        const scalar V = grains_.mappedVolume()[graini];
        const scalar inertia =
            V*grains_.motion().density(graini)
           *squaredGyration*sqr(grains_.fluidDiameter(graini));

        torque[graini] +=
            (viscous[graini] - 2*grainMu[graini]*V*grains_.motion().spin(graini))
           /(1 + resistance[graini]*mesh_.time().deltaTValue()/inertia);
    }
}
