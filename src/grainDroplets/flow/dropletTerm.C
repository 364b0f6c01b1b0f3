/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletTerm.H"

#include "combineOverRanks.H"


Foam::dropletTerm::dropletTerm
(
    const liquidDroplets& droplets,
    const thermalFluid& fluid
)
:
    droplets_(droplets),
    fluid_(fluid),
    bodies_(droplets.system(), fluid, droplets.from()),
    around_(fluid, droplets.properties())
{}


void Foam::dropletTerm::update()
{
    bodies_.update();
    around_.update(*this);
}


void Foam::dropletTerm::forces
(
    const volVectorField& U,
    const surfaceScalarField& mu,
    vectorField& force,
    vectorField& torque
) const
{
    force = vectorField(droplets_.size(), Zero);
    torque = vectorField(droplets_.size(), Zero);
    bodies_.addForce(U, force);
    sumOverRanks(force);
    bodies_.addViscousTorque(U, mu, torque);
}


Foam::vector Foam::dropletTerm::impulseOnOthers(const volVectorField& U) const
{
    vectorField force(droplets_.size(), Zero);
    bodies_.addForce(U, force);
    vector sum(Foam::sum(force));

    const grainSystem& system = droplets_.system();
    const buoyancy weight(system, fluid_);
    for (const cellOverlap& o : system.overlaps().all())
    {
        sum -= weight.force(o.volume, o.cell);
    }
    return
        system.mesh().time().deltaTValue()
       *returnReduce(sum, sumOp<vector>());
}
