/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lockedGrains.H"

#include "fvc.H"
#include "fvm.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "uncorrectedSnGrad.H"

Foam::lockedGrains::lockedGrains
(
    const grainSystem& grains,
    const carrier& fluid,
    const scalar from
)
:
    grains_(grains),
    mesh_(grains.mesh()),
    fluid_(fluid),
    weight_(grains, fluid),
    cells_(grains, fluid, from),
    areLight_(false),
    freeU_
    (
        IOobject("freeU", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimVelocity, Zero)
    ),
    lastU_("lastU", freeU_),
    rigidForce_
    (
        IOobject("rigidForce", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimForce/dimLength, Zero)
    )
{}


void Foam::lockedGrains::setFreeMotion(const scalarField& rho)
{
    const scalar deltaT = mesh_.time().deltaTValue();

    free_.resize(grains_.size());
    forAll(free_, graini)
    {
        if (cells_.isResolved(graini))
        {
            free_[graini] =
                motionInStep
                (
                    grains_.motion(),
                    weight_,
                    graini,
                    grains_.motion().motion(graini),
                    rho[graini],
                    deltaT
                );

            // Without what contacts turn: the fluid's torque, which holds it, is
            // not known yet (doc/theory, eq. 3.3)
            free_[graini].spin = grains_.motion().spin(graini);
        }
    }

    freeU_ == dimensionedVector(dimVelocity, Zero);
    lastU_ == dimensionedVector(dimVelocity, Zero);
    forAll(freeU_, celli)
    {
        const label graini = cells_.grain(celli);
        if (graini >= 0)
        {
            const vector arm(cells_.arm(celli));
            freeU_[celli] = free_[graini].at(arm);
            lastU_[celli] = grains_.motion().motion(graini).at(arm);
        }
    }
    freeU_.correctBoundaryConditions();
    lastU_.correctBoundaryConditions();
}


void Foam::lockedGrains::setFreeOfLast(const scalarField& rho)
{
    const volScalarField tangent
    (
        fvc::average(mag(mesh_.nonOrthCorrectionVectors()))
    );
    freeOfLast_ = cells_.meanOfCells<scalar>
    (
        tangent.primitiveField(), scalarField(mesh_.nCells(), 1)
    );

    forAll(freeOfLast_, graini)
    {
        const scalar heavier =
            cells_.isResolved(graini)
          ? max(grains_.motion().density(graini)/rho[graini] - 1, 0)
          : 0;
        freeOfLast_[graini] *= heavier/(1 + heavier*freeOfLast_[graini]);
    }
}


bool Foam::lockedGrains::areLight(const scalarField& rho) const
{
    // Density over the fluid's below which the corrections of the pressure do not take
    // back what the predictor makes of the free motion
    constexpr scalar light = 0.03;

    for (label graini = 0; graini < grains_.size(); ++graini)
    {
        if
        (
            cells_.isResolved(graini)
         && grains_.motion().density(graini) < light*rho[graini]
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::lockedGrains::update()
{
    cells_.update();
    ownForce_.clear();
    if (isActive())
    {
        const scalarField rho(weight_.displaced());
        areLight_ = !grains_.motion().isFixed() && areLight(rho);
        setFreeMotion(rho);
        if (!grains_.motion().isFixed())
        {
            setFreeOfLast(rho);
        }
        rigidForce_ == dimensionedScalar(rigidForce_.dimensions(), Zero);
    }
}


void Foam::lockedGrains::addInertia(exchangeFields& fields)
{
    if (!isActive())
    {
        return;
    }
    const scalar deltaT = mesh_.time().deltaTValue();
    forAll(freeU_, celli)
    {
        const label graini = cells_.grain(celli);
        if (graini >= 0)
        {
            const scalar inertia = cells_.density(graini)/deltaT;
            fields.kappa[celli] += 1;
            fields.beta[celli] += inertia;
            fields.b[celli] += inertia*freeU_[celli];
        }
    }
    cellInertia_ = fields.beta.primitiveField();
}


void Foam::lockedGrains::addToMomentum
(
    fvVectorMatrix& UEqn,
    const surfaceScalarField& massFlux,
    const surfaceScalarField& mu
) const
{
    if (!isActive())
    {
        return;
    }
    UEqn +=
        (1 - locked())
       *fvc::surfaceIntegrate(massFlux*cells_.faceExcess(UEqn.psi()));
    UEqn -= fvc::surfaceIntegrate
    (
        mu*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()*cells_.wallJump()
    );
}


Foam::tmp<Foam::volVectorField> Foam::lockedGrains::onWholeGrains
(
    const volVectorField& force
) const
{
    if (grains_.motion().isFixed())
    {
        return force;
    }
    tmp<volVectorField> tresult(new volVectorField("force", force));
    volVectorField& result = tresult.ref();

    vectorField acceleration(mesh_.nCells(), Zero);
    forAll(acceleration, celli)
    {
        if (cells_.grain(celli) >= 0)
        {
            acceleration[celli] = force[celli]/cellInertia_[celli];
        }
    }
    const vectorField whole(cells_.meanOfCells(acceleration, cellInertia_));
    forAll(acceleration, celli)
    {
        const label graini = cells_.grain(celli);
        if (graini >= 0)
        {
            result[celli] +=
                freeOfLast_[graini]*cellInertia_[celli]
               *(whole[graini] - acceleration[celli]);
        }
    }
    return tresult;
}


void Foam::lockedGrains::predict
(
    fvVectorMatrix& UEqn,
    const volVectorField& pressureForce
) const
{
    if (!isActive())
    {
        resolvedTerm::predict(UEqn, pressureForce);
        return;
    }

    if (areLight_)
    {
        return;
    }

    // Grains move as rigid bodies within the step.  What holds them together is
    // known from then on: it would slow down the correction of the pressure.
    // Beside the surface gradients of the two velocities differ, even if the
    // velocities do not: no correction for faces that are not orthogonal.
    fv::gaussLaplacianScheme<vector, scalar> laplacian
    (
        mesh_,
        tmp<surfaceInterpolationScheme<scalar>>(new linear<scalar>(mesh_)),
        tmp<fv::snGradScheme<vector>>(new fv::uncorrectedSnGrad<vector>(mesh_))
    );
    const surfaceScalarField& stiff = cells_.rigidity();
    const fvVectorMatrix rigidity
    (
        laplacian.fvmLaplacian(stiff, UEqn.psi())
      - laplacian.fvcLaplacian(stiff, freeU_)
    );
    solve(UEqn - rigidity == -onWholeGrains(pressureForce));
    UEqn -= (rigidity & UEqn.psi());
}
