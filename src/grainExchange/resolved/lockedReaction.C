/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lockedGrains.H"

void Foam::lockedGrains::addForce
(
    const volVectorField& U,
    vectorField& force
) const
{
    if (!isActive())
    {
        return;
    }
    const overlapList& overlaps = grains_.overlaps();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (isResolved(graini))
        {
            for (const cellOverlap& o : overlaps.of(graini))
            {
                force[graini] += weight_.forceInCell(o.volume, o.cell);
            }
        }
    }

    const scalar deltaT = mesh_.time().deltaTValue();
    forAll(U, celli)
    {
        const label graini = cells_.grain(celli);
        if (graini >= 0)
        {
            force[graini] +=
                mesh_.V()[celli]*cells_.density(graini)/deltaT
               *(U[celli] - freeU_[celli]);
        }
    }
}


void Foam::lockedGrains::addPressureTorque
(
    const volScalarField& p_rgh,
    const volScalarField& p,
    vectorField& torque
) const
{
    cells_.addPressureTorque(p_rgh, p, torque);
}


void Foam::lockedGrains::addViscousTorque
(
    const volVectorField& U,
    const surfaceScalarField& mu,
    vectorField& torque
) const
{
    cells_.addTorque(U, mu, torque);
}
