/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFlow.H"

#include "fvCFD.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "reconstruction.H"
#include "wallPolyPatch.H"

namespace
{

//- Whether further corrections for faces that are not orthogonal change anything
class nonOrthogonalProgress
{
    Foam::scalar last_ = Foam::GREAT;

    bool isOver_ = false;

public:

    //- Where a solver finds nothing left to do, or what it finds is round-off
    void add(const Foam::solverPerformance& solution)
    {
        constexpr Foam::scalar roundOff = 1e-12;

        const Foam::scalar residual = solution.initialResidual();
        isOver_ =
            solution.nIterations() == 0
         || (residual < roundOff && residual > 0.5*last_);
        last_ = residual;
    }

    bool isOver() const { return isOver_; }
};


bool isLast(const Foam::pimpleControl& control)
{
    return control.corrPISO() == control.nCorrPISO();
}


//- Is this the last correction of a step that ends with an equation of momentum
//  that is solved?
bool isClosing(const Foam::pimpleControl& control)
{
    return isLast(control) && control.dict().getOrDefault("closeMomentum", false);
}

}


Foam::tmp<Foam::surfaceScalarField> Foam::vansFlow::fluxWithoutPressure
(
    const volVectorField& H
) const
{
    const faceMomentum& faces = *faces_;
    const volVectorField& U = fields_.U;

    const volVectorField HbyA
    (
        constrainHbyA
        (
            (H - step_->b + (faces.A - faces.fluidA)*U)/faces.A,
            U,
            fields_.p_rgh
        )
    );

    tmp<surfaceScalarField> tflux(
        faces.fluxWithoutPressure(HbyA, *step_, grains_)
    );
    resolved_.correctFlux
    (
        faces.A*HbyA,
        fields_.phi.oldTime(),
        fields_.phiU.oldTime(),
        U,
        step_->phib,
        tflux.ref()
    );
    return tflux;
}


Foam::tmp<Foam::surfaceScalarField> Foam::vansFlow::solvePressure
(
    const surfaceScalarField& phiHbyA,
    pimpleControl& control
)
{
    const faceMomentum& faces = *faces_;
    volScalarField& p_rgh = fields_.p_rgh;
    const volVectorField& U = fields_.U;
    const tmp<surfaceScalarField>& force = step_->faceForce;

    surfaceScalarField phiMixture("phiMixture", phiHbyA);
    if (faces.part.valid())
    {
        phiMixture = faces.part()*phiMixture;
    }
    resolved_.addToFlux(phiMixture);
    adjustPhi(phiMixture, U, p_rgh);
    if (force.valid())
    {
        phiMixture -= faces.mobility*force();
    }
    constrainPressure(p_rgh, U, phiMixture, faces.mobility);

    tmp<volScalarField> source(fvc::div(phiMixture));
    if (volumeSource_.valid())
    {
        source.ref() -= volumeSource_();
    }
    if (resolved_.isActive())
    {
        volScalarField comesIn("comesIn", 0*source());
        resolved_.addVolumeSource(grains_, U, comesIn);
        source.ref() -= comesIn;
    }

    tmp<surfaceScalarField> tgradient;
    nonOrthogonalProgress progress;
    while (control.correctNonOrthogonal())
    {
        const bool isFinal = control.finalNonOrthogonalIter();
        if (progress.isOver() && !isFinal)
        {
            continue;
        }
        fvScalarMatrix p_rghEqn
        (
            fvm::laplacian(faces.diffusivity, p_rgh) == source()
        );
        p_rghEqn.setReference(pRefCell_, getRefCellValue(p_rgh, pRefCell_));
        progress.add
        (
            p_rghEqn.solve
            (
                mesh_.solverDict(p_rgh.select(control.finalInnerIter()))
            )
        );

        // At once: OpenFOAM trips over the residual of the next solution
        checkFinite();

        if (isFinal)
        {
            tgradient = p_rghEqn.flux()/faces.diffusivity;
            fields_.phi = phiMixture - faces.mobility*tgradient();
        }
    }
    if (force.valid())
    {
        tgradient.ref() += force();
    }

    fields_.phiOpen = phiHbyA - faces.rAUf*tgradient();
    fields_.phiU =
        (
            fields_.phi
          - fvc::flux(grains_.G)
          + fvc::interpolate(grains_.K)*tgradient()
        )
       /fvc::interpolate(step_->alpha);
    fields_.phiMomentum =
        faces.fluidFlux(fields_.phi, tgradient(), step_->alpha, grains_);
    if (resolved_.isActive())
    {
        // At a body the flux is that of its surface, and fluid beside it moves so
        const surfaceScalarField& locked = resolved_.lockedFaces();
        for (surfaceScalarField* flux : fields_.fluxes())
        {
            *flux += locked*(fields_.phiOpen - *flux);
        }
    }
    for (surfaceScalarField* flux : fields_.fluxesOfFluid())
    {
        resolved_.correctFaceVelocity(fields_.phiOpen, tgradient(), *flux);
    }
    fields_.areOfStep = true;
    return tgradient;
}


bool Foam::vansFlow::accelerates(const label patchi) const
{
    if (mesh_.moving())
    {
        return isA<wallPolyPatch>(mesh_.boundaryMesh()[patchi]);
    }
    return
        fields_.U.boundaryField()[patchi].fixesValue()
     && !fields_.p_rgh.boundaryField()[patchi].fixesValue();
}


void Foam::vansFlow::addForceOfGivenVelocity(surfaceScalarField& gradient) const
{
    constexpr scalar roundOff = 1e-10;

    const scalar deltaT = mesh_.time().deltaTValue();
    const surfaceScalarField& before = fields_.phiMomentum.oldTime();
    forAll(mesh_.boundary(), patchi)
    {
        if (!accelerates(patchi))
        {
            continue;
        }
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fvPatchVectorField& oldU = fields_.U.oldTime().boundaryField()[patchi];
        const scalarField oldFlux
        (
            isFirst_ && mesh_.moving()
          ? patch.Sf() & oldU.patchInternalField()
          : tmp<scalarField>(fields_.phiU.oldTime().boundaryField()[patchi])
        );
        const scalarField& flux = fields_.phiU.boundaryField()[patchi];
        scalarField change(weights_.before*(flux - oldFlux));
        if (weights_.earlier > 0)
        {
            change -=
                weights_.earlier
               *(flux - before.oldTime().boundaryField()[patchi]);
        }
        const scalar least = roundOff*gMax((mag(flux) + mag(oldFlux))());
        if (gMax(mag(change)()) <= least || patch.size() == 0)
        {
            continue;
        }
        const auto inCells = [&](const volScalarField& x)
        {
            return scalarField(x.boundaryField()[patchi].patchInternalField());
        };
        if (mesh_.moving())
        {
            change -=
                patch.Sf()
              & grains_.gained.boundaryField()[patchi].patchInternalField()();
        }
        const scalarField inertia(inCells(step_->inertia)/deltaT);
        gradient.boundaryFieldRef()[patchi] -=
            inertia
           /(
                inCells(step_->alpha)*inCells(step_->share)
              + inCells(grains_.K)*(inertia + inCells(step_->beta))
            )
           *change;
    }
}


void Foam::vansFlow::setPressure()
{
    volScalarField& p_rgh = fields_.p_rgh;
    const volScalarField& rho = fluid_.rhoWeight();

    p_ = p_rgh + rho*gh_();
    if (p_rgh.needReference())
    {
        p_ += dimensionedScalar
        (
            "p", p_.dimensions(), pRefValue_ - getRefCellValue(p_, pRefCell_)
        );
        p_rgh = p_ - rho*gh_();

        // As a restart will find them, not to round-off
        p_rgh.correctBoundaryConditions();
    }
}


void Foam::vansFlow::addDragAtPatches()
{
    if (gMax(grains_.beta.primitiveField()) == 0 || resolved_.isActive())
    {
        return;
    }
    forAll(p_.boundaryField(), patchi)
    {
        fvPatchScalarField& p = p_.boundaryFieldRef()[patchi];
        if
        (
            !p.coupled() && !grains_.freePatches.found(patchi)
         && !fields_.p_rgh.boundaryField()[patchi].fixesValue()
        )
        {
            const fvPatch& patch = p.patch();
            const scalarField& flux = fields_.phi.boundaryField()[patchi];
            const auto inCells = [&](const auto& x)
            {
                return x.boundaryField()[patchi].patchInternalField();
            };
            scalarField gradient
            (
                (inCells(step_->bByShare) & patch.nf())
              - inCells(step_->betaByShare)*flux/patch.magSf()
            );
            if (inertial_.valid())
            {
                gradient += inertial_->atPatch
                (
                    patchi, flux - fields_.phi.oldTime().boundaryField()[patchi]
                );
            }
            p == p + gradient*(patch.nf() & patch.delta());
        }
    }
}


bool Foam::vansFlow::hasWeightAndGrains() const
{
    return
        step_->faceForce.valid()
     && (resolved_.isActive() || gMin(step_->eps.primitiveField()) < 1);
}


void Foam::vansFlow::densityChanged()
{
    if (!hasWeightAndGrains())
    {
        return;
    }
    volScalarField& p_rgh = fields_.p_rgh;
    volScalarField kept("kept", p_ - fluid_.rhoWeight()*gh_());
    forAll(p_rgh.boundaryField(), patchi)
    {
        if (p_rgh.boundaryField()[patchi].fixesValue())
        {
            kept.boundaryFieldRef()[patchi] = p_rgh.boundaryField()[patchi];
        }
    }
    p_rgh == kept;
}


void Foam::vansFlow::correct(pimpleControl& control)
{
    volVectorField& U = fields_.U;
    resolved_.correctSource(*UEqn_);
    const volVectorField H("H", UEqn_->H());

    tmp<surfaceScalarField> gradient
    (
        solvePressure(fluxWithoutPressure(H), control)
    );
    addForceOfGivenVelocity(gradient.ref());
    const volVectorField force(pressureForce(gradient()));
    gradP_ = force/step_->share;

    if (isClosing(control) && !resolved_.isActive())
    {
        // With neighbours as they are in the end: what they give each other adds up
        // to nothing
        solve(*UEqn_ == -force);
    }
    else
    {
        U = (H - force)/UEqn_->A();
    }
    resolved_.correctMotion(U, fields_.phi, step_->betaf);
    U.correctBoundaryConditions();
    options_.correct(U);

    setPressure();
    if (isLast(control))
    {
        addDragAtPatches();
    }
}
