/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFlow.H"

#include "convectionByFraction.H"
#include "ddtScheme.H"
#include "fvCFD.H"
#include "gaussConvectionScheme.H"
#include "localMax.H"
#include "reconstruction.H"
#include "shearLayers.H"
#include "upwind.H"

namespace
{

using namespace Foam;

//- From 0 to 1 between two values
tmp<scalarField> rising
(
    const scalarField& x,
    const scalar from,
    const scalar to
)
{
    return min(max((x - from)/(to - from), scalar(0)), scalar(1));
}


//- Rate of change of the cells' volumes by the scheme of U, over the volume
tmp<volScalarField> ddtOfOne(const volVectorField& U)
{
    volScalarField one
    (
        IOobject("one", U.time().timeName(), U.mesh()),
        U.mesh(),
        dimensionedScalar("one", dimless, 1)
    );
    for (volScalarField* old = &one; one.nOldTimes() < U.nOldTimes();)
    {
        old = &old->oldTime();
    }
    return fv::ddtScheme<scalar>::New
    (
        U.mesh(), U.mesh().ddtScheme("ddt(U)")
    ).ref().fvcDdt(one);
}


//- Force of grains in cells of fluid at their faces to locked ones, times the area
//  [Pa m]
tmp<surfaceScalarField> besideLocked
(
    const resolvedTerm& resolved,
    const surfaceScalarField& flux,
    const volVectorField& b,
    const volScalarField& beta
)
{
    const volScalarField open("open", 1 - resolved.locked());
    return
        resolved.lockedFaces()
       *(
            fvc::flux(open*b) - fvc::interpolate(open*beta)*flux
        )
       /max(fvc::interpolate(open), scalar(SMALL));
}

}


Foam::tmp<Foam::surfaceScalarField> Foam::vansFlow::upwindShare() const
{
    const stepCoefficients& step = *step_;
    const scalarField courant
    (
        0.5*mesh_.time().deltaTValue()
       *fvc::surfaceSum(mag(step.massFlux))().primitiveField()
       /((step.eps*fluid_.rho())().primitiveField()*mesh_.V())
    );
    const scalarField fluid
    (
        step.eps.primitiveField()
       /max(resolved_.open()().primitiveField(), exchangeFields::epsMin)
    );
    volScalarField share("upwindShare", 0*step.eps);
    share.primitiveFieldRef() =
        (1 - resolved_.locked()().field())
       *rising(courant, 0.05, 0.25)
       *rising(-fluid, -0.4, -0.3);
    share.correctBoundaryConditions();
    return localMax<scalar>(mesh_).interpolate(share);
}


Foam::tmp<Foam::fvVectorMatrix> Foam::vansFlow::convection
(
    const surfaceScalarField& share
) const
{
    const volVectorField& U = fields_.U;
    const surfaceScalarField flux
    (
        step_->massFlux.name(), resolved_.convectedByScheme(step_->massFlux)
    );
    const surfaceScalarField upwinded(share*flux);
    const surfaceScalarField byScheme(flux.name(), flux - upwinded);

    return
        (1 - resolved_.locked()())
       *(
            fvm::div(byScheme, U)
          + fv::gaussConvectionScheme<vector>
            (
                mesh_,
                upwinded,
                tmp<surfaceInterpolationScheme<vector>>
                (
                    new upwind<vector>(mesh_, upwinded)
                )
            ).fvmDiv(upwinded, U)
          - fvm::Sp(fvc::div(flux), U)
        );
}


Foam::tmp<Foam::volVectorField> Foam::vansFlow::convectionAsForce
(
    const surfaceScalarField& share
) const
{
    constexpr scalar roundOff = 1e-10;

    const volScalarField moves("moves", step_->alpha + grains_.mobile);
    if (resolved_.isActive() || gMin(moves.primitiveField()) > 1 - roundOff)
    {
        return tmp<volVectorField>();
    }
    const surfaceScalarField flux
    (
        step_->massFlux.name(), (1 - share)*step_->massFlux
    );
    return convectionByFraction(flux, fields_.U, moves, grains_);
}


Foam::tmp<Foam::volVectorField> Foam::vansFlow::divTau() const
{
    // Zero but where the viscosity varies.  At the surface of a resolved grain
    // the velocity gradient, which jumps, is not to be had from the cells.
    return
        resolved_.openCells()
       *fvc::div(step_->mu*dev2(T(fvc::grad(fields_.U))), "div(tau)");
}


Foam::tmp<Foam::fvVectorMatrix> Foam::vansFlow::sources()
{
    return
        options_.PtrList<fv::option>::empty()
      ? tmp<fvVectorMatrix>()
      : options_(fluid_.rho(), fields_.U);
}


void Foam::vansFlow::setMomentumEquation
(
    tmp<fvVectorMatrix>& sources,
    const surfaceScalarField& share,
    const tmp<volVectorField>& asForce
)
{
    const stepCoefficients& step = *step_;
    volVectorField& U = fields_.U;

    surfaceScalarField muf(step.muf.name(), step.muf);
    tmp<surfaceScalarField> layers;
    if
    (
        !resolved_.isActive()
     && gMax(grains_.betaOfLayers.primitiveField()) > 0
    )
    {
        layers = viscosityOfLayers
        (
            step.mu, grains_.betaOfLayers, grains_.fluidShare
        );
        muf += layers();
    }

    // As fvm::ddt has them, which makes the earlier value if there is none
    weights_ = weightsInTime(mesh_, U.nOldTimes() > 1);
    UEqn_.reset
    (
        new fvVectorMatrix
        (
            step.inertia*fvm::ddt(U)
          + convection(share)
          - fvm::laplacian(muf*resolved_.conductance(), U)
          - divTau()
          + fvm::Sp(step.beta, U)
         ==
            step.b
        )
    );
    fvVectorMatrix& UEqn = *UEqn_;

    const tmp<volVectorField> onGrains(fluid_.forceOnGrains());
    if (onGrains.valid())
    {
        UEqn -= resolved_.locked()*onGrains();
    }
    if (asForce.valid())
    {
        UEqn -= asForce();
    }
    if (layers.valid())
    {
        UEqn += forceAcross(layers(), U);
    }
    if (step.wallDrag.valid())
    {
        UEqn += fvm::Sp(step.eps*step.wallDrag(), U);
    }
    if (mesh_.moving())
    {
        // A cell whose volume changes keeps its velocity
        UEqn -= fvm::Sp(step.inertia*ddtOfOne(U), U);
    }
    if (sources.valid())
    {
        resolved_.shareSources(sources.ref());
        UEqn -= sources;
    }
    resolved_.addToMomentum(UEqn, step.massFlux, step.muf);
    UEqn.relax();
    options_.constrain(UEqn);
}


Foam::tmp<Foam::volVectorField> Foam::vansFlow::pressureForce
(
    const surfaceScalarField& gradient
) const
{
    // Where the drag differs between two cells the pressure has a kink at their
    // face: a cell sees the gradient on its own side, which is the face's, plus
    // what its own drag at the face's velocity is more than the face's.  Without
    // grains it is the reconstruction of the face gradients.  At the velocity of a
    // flux that is made from U, through a cell that a fixed grain covers, the drag
    // would be boundless: the gradient holds none of it yet.
    const stepCoefficients& step = *step_;
    const tmp<surfaceScalarField> tflux
    (
        resolved_.fluxInOpen(fields_.phi, fields_.phiU, gradient)
    );
    const surfaceScalarField& flux = tflux();
    const scalar kinks = fields_.areOfStep ? 1 : 0;

    if (inertial_.valid())
    {
        return
            step.share
           *inertial_->gradient(gradient, flux, fields_.phi.oldTime());
    }
    surfaceScalarField faceForce("faceForce", gradient - kinks*step.phib);
    resolved_.correctFaceForce(faceForce);
    faceForce += kinks*step.betaf*flux;

    const volScalarField still("still", kinks*step.still + (1 - kinks));
    faceForce /=
        (1 - resolved_.lockedFaces())*fvc::interpolate(still)
      + resolved_.lockedFaces();

    const volVectorField b("b", kinks*step.bByShare);
    const volScalarField beta("beta", kinks*step.betaByShare);

    volVectorField result
    (
        "pressureForce",
        still*reconstructed(faceForce) + b - beta*reconstructed(flux)
    );
    if (resolved_.isActive())
    {
        const surfaceScalarField atLocked
        (
            kinks
           *besideLocked(resolved_, flux, grains_.bBeside, grains_.betaBeside)
        );
        result +=
            (1 - resolved_.locked())
           *reconstructed
            (
                atLocked
              - besideLocked(resolved_, flux, b, beta)
              + besideLocked(resolved_, faceForce, 0*b, still - 1)
            );
        resolved_.correctForce
        (
            faceForce,
            flux,
            step.eps*fluid_.rho(),
            {gradient, flux, still, b, beta, atLocked},
            result
        );
    }
    return step.share*result;
}


bool Foam::vansFlow::mayPredict(const label correctors) const
{
    if (!fields_.areOfStep && hasWeightAndGrains())
    {
        return false;
    }
    // New cells that unresolved grains fill have the fluid velocity of a larger one
    if
    (
        mesh_.topoChanging()
     && gMin((grains_.fluidShare + resolved_.locked())().primitiveField()) < 0.1
    )
    {
        return false;
    }

    const surfaceScalarField nu(step_->muf/fvc::interpolate(fluid_.rho()));
    const scalar diffusion =
        gMax((nu.primitiveField()*sqr(mesh_.deltaCoeffs().primitiveField()))())
       *mesh_.time().deltaTValue();
    if (diffusion <= 1)
    {
        return true;
    }

    const scalar thickest = gMax
    (
        (
            step_->mu.primitiveField()
           /max(fluid_.muStress().primitiveField(), VSMALL)
        )()
    );
    const scalar needed =
        thickest > 2 ? 1 + 2*sqrt(diffusion) : diffusion > 2 ? 3 : 0;
    if (correctors < needed && !saysFew_)
    {
        saysFew_ = true;
        Info<< "Momentum  nu deltaT/h^2 is " << diffusion << " in some cell";
        if (thickest > 2)
        {
            Info<< ", and grains make the viscosity " << thickest
                << " times the fluid's: no predictor with less than "
                << label(ceil(needed)) << " nCorrectors";
        }
        else
        {
            Info<< ": with a predictor the pressure may grow without bound,"
                << " take 3 nCorrectors or more, or shorter steps";
        }
        Info<< " (said once)" << endl;
    }
    return thickest <= 2 || correctors >= needed;
}


void Foam::vansFlow::predict(const pimpleControl& control)
{
    const volScalarField& p_rgh = fields_.p_rgh;

    surfaceScalarField gradient
    (
        "gradient", fvc::snGrad(p_rgh)*mesh_.magSf()
    );
    if (step_->faceForce.valid())
    {
        gradient += step_->faceForce();
    }
    inertial_.clear();
    if
    (
        !isFirst_ && !resolved_.isActive()
     && !isSecondOrderInTime(mesh_)
     && gMin(step_->eps.primitiveField()) < 1
    )
    {
        inertial_.reset(new inertialForce(*step_, grains_, fluid_.rho()));
    }
    const volVectorField force(pressureForce(gradient));
    gradP_ = force/step_->share;

    if (control.momentumPredictor() && mayPredict(control.nCorrPISO()))
    {
        resolved_.predict(*UEqn_, force);
        options_.correct(fields_.U);
        checkFinite();
    }

    faces_.reset
    (
        new faceMomentum
        (
            *UEqn_, *step_, grains_, resolved_, fluid_.rho(), fields_.phiMomentum
        )
    );
}
