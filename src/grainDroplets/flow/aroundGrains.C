/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aroundGrains.H"


Foam::aroundGrains::aroundGrains
(
    const thermalFluid& fluid,
    const liquid& inDroplets
)
:
    fluid_(fluid),
    liquid_(inDroplets),
    rho_("rhoAroundGrains", fluid.rho()),
    rhoWeight_("rhoWeightAroundGrains", fluid.rhoWeight()),
    mu_("muAroundGrains", fluid.mu()),
    kappa_("kappaAroundGrains", fluid.kappa()),
    isLiquid_(rho_.size(), false)
{}


void Foam::aroundGrains::update(const resolvedTerm& droplets)
{
    rho_ == fluid_.rho();
    rhoWeight_ == fluid_.rhoWeight();
    mu_ == fluid_.mu();
    kappa_ == fluid_.kappa();
    isLiquid_.resize(rho_.size());
    forAll(isLiquid_, celli)
    {
        isLiquid_[celli] = droplets.isLiquid(celli);
        rhoWeight_[celli] +=
            (isLiquid_[celli] ? 1 : droplets.inLiquid(celli))
           *(liquid_.density - rhoWeight_[celli]);
        if (isLiquid_[celli])
        {
            rho_[celli] = liquid_.density;
            mu_[celli] = liquid_.mu;
            kappa_[celli] = liquid_.film;
        }
    }
    rho_.correctBoundaryConditions();
    rhoWeight_.correctBoundaryConditions();
    mu_.correctBoundaryConditions();
    kappa_.correctBoundaryConditions();
}
