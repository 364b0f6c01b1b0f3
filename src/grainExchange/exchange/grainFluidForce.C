/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

#include "combineOverRanks.H"
#include "fvcFlux.H"
#include "meanOverGrains.H"

Foam::vector Foam::grainFluidExchange::momentumOfCells
(
    const volVectorField& U,
    const volVectorField& gradP
) const
{
    const scalar deltaT = mesh_.time().deltaTValue();
    const scalar onGrains = fields_.gradientOnGrains;

    vector result(Zero);
    const volScalarField& eps = epsAmongGrains();
    forAll(eps, celli)
    {
        // In a liquid the reaction to buoyancy is part of b
        if (!resolved_->isLiquid(celli))
        {
            const scalar volume = (1 - eps[celli])*mesh_.V()[celli];
            result += deltaT
               *(
                    weight_.forceInCell(volume, celli)
                  - weight_.force
                    (
                        resolved_->inLiquid(celli)*volume,
                        resolved_->ofLiquid().density
                    )
                );
        }
        result += deltaT*mesh_.V()[celli]
           *(
                onGrains*(fields_.kappa[celli] - 1 + fields_.fluidShare[celli])
               *gradP[celli]
              + fields_.beta[celli]*U[celli] - fields_.b[celli]
            );
        result +=
            deltaT*resolved_->forceOfCell(celli, U[celli], gradP[celli]);
    }
    return returnReduce(result, sumOp<vector>());
}


void Foam::grainFluidExchange::foreseeContacts(const volVectorField& cellU)
{
    vectorField force(grains_.size(), Zero);
    scalarField massOfDrag(grains_.size(), Zero);
    unresolved_.addForceAtStart
    (
        seenByGrains(cellU)(), *resolved_, force, massOfDrag
    );
    sumOverRanks(force);
    sumOverRanks(massOfDrag);

    // At openings the part outside is held as that in the mesh is
    const scalarField displaced(weight_.displaced());
    forAll(force, graini)
    {
        const scalar volume = grains_.volume(graini);
        if (resolved_->isResolved(graini))
        {
            force[graini] += weight_.force(volume, displaced[graini]);
        }
        else if (grains_.isAtOpening(graini))
        {
            const scalar whole = volume/grains_.mappedVolume()[graini];
            force[graini] *= whole;
            massOfDrag[graini] *= whole;
        }
    }
    grains_.foresee(force, massOfDrag, mesh_.time().deltaTValue());
}


void Foam::grainFluidExchange::setImpacts()
{
    grains_.entrain(resolved_->entrained(grains_, weight_));
    if (lubrication_)
    {
        grains_.lubricate
        (
            [this](const scalar e, const scalar St)
            {
                return lubrication_->restitution(e, St);
            },
            meanOverGrains(grains_, aroundGrains_.mu().primitiveField())
        );
    }
}


void Foam::grainFluidExchange::moveGrains
(
    const volVectorField& cellU,
    const volVectorField& cellGradP,
    const surfaceScalarField& mu
)
{
    const stopwatch::lap lap(time_);
    const scalar deltaT = mesh_.time().deltaTValue();

    vectorField force(grains_.size(), Zero);
    vectorField torque(grains_.size(), Zero);
    {
        const tmp<volVectorField> U(seenByGrains(cellU));
        const tmp<volVectorField> gradP(seenByGrains(cellGradP));
        unresolved_.addForce(U(), gradP(), *resolved_, force, torque);
    }
    resolved_->addPressureTorque
    (
        mesh_.lookupObject<volScalarField>("p_rgh"),
        mesh_.lookupObject<volScalarField>("p"),
        torque
    );
    resolved_->addForce(cellU, force);

    sumOverRanks(force);
    sumOverRanks(torque);
    resolved_->addViscousTorque(cellU, mu, torque);

    given_ =
        momentumOfCells(cellU, cellGradP) - resolved_->impulseOnOthers(cellU);
    received_ = deltaT*sum(force);
    openings_.extendForce(*resolved_, force, torque);

    setImpacts();
    unresolved_.keep(cellGradP);
    grains_.move(force, torque, deltaT);
    fields_.crossing = crossing_.flux();
    setEps();
}


void Foam::grainFluidExchange::addCrossing(const Map<scalarField>& others)
{
    forAllConstIters(others, iter)
    {
        const scalarField& flux = iter.val();
        if (fields_.crossing.found(iter.key()))
        {
            fields_.crossing[iter.key()] += flux;
        }
        else
        {
            fields_.crossing.insert(iter.key(), flux);
        }
    }
}


void Foam::grainFluidExchange::discharge
(
    volVectorField& U,
    const std::array<surfaceScalarField*, 2>& fluxes
)
{
    const stopwatch::lap lap(time_);
    const std::vector<bool> gone(grains_.leaving());
    scalarField share;
    vectorField flux;
    const bool isAny = openings_.shareOf(gone, share, flux);
    unresolved_.discharge(gone);
    grains_.discharge(gone);

    filled_.clear();
    if (!isAny)
    {
        return;
    }
    grains_.voidFraction().smooth(share);
    grains_.voidFraction().smooth(flux);

    // The fluid that takes their place moves as they did: the mixture's velocity
    // stays, and no pressure is needed to change it
    volVectorField change
    (
        IOobject("changeOfU", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimVelocity, Zero)
    );
    filled_ = -eps_.primitiveField();
    forAll(share, celli)
    {
        if (share[celli] > 0)
        {
            change[celli] =
                (flux[celli] - share[celli]*U[celli])
               /(eps_[celli] + share[celli]);
        }
    }
    setEps();
    filled_ += eps_.primitiveField();

    change.correctBoundaryConditions();
    U += change;
    U.correctBoundaryConditions();
    const surfaceScalarField fluxOfChange(fvc::flux(change));
    for (surfaceScalarField* flux : fluxes)
    {
        *flux += fluxOfChange;
    }
}
