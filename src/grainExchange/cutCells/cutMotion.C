/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "combineOverRanks.H"
#include "motionInStep.H"

void Foam::cutGrains::setFreeMotion()
{
    const scalarField rho(weight_.displaced());
    free_.resize(grains_.size());
    motion_.resize(grains_.size());
    forAll(motion_, graini)
    {
        if (grains_.motion().isFixed())
        {
            free_[graini] = motion_[graini] = grainMotion::twist{Zero, Zero};
            continue;
        }
        motion_[graini] = grains_.motion().motion(graini);
        free_[graini] =
            motionInStep
            (
                grains_.motion(),
                weight_,
                graini,
                motion_[graini],
                rho[graini],
                mesh_.time().deltaTValue()
            );
    }
    inSource_ = motion_;
    resists_.resize(grains_.size());
    resists_ = Zero;
    resistsTurning_.resize(grains_.size());
    resistsTurning_ = Zero;
}


void Foam::cutGrains::setResistance()
{
    resists_ = Zero;
    resistsTurning_ = Zero;
    const auto add = [&](const label graini, const scalar k, const vector& arm)
    {
        resists_[graini] += k;
        if (isCluster_[graini])
        {
            resistsTurning_[graini] += k*(magSqr(arm)*tensor::I - arm*arm);
        }
    };
    forAll(link_, i)
    {
        const cutCells::wall& x = cells_.walls()[i];
        add(x.grain, link_[i]*(1 - follows(i)), x.arm);
        add(x.grain, resistanceInside(x), armOf(x.grain, x.cell));
    }
    sumOverRanks(resists_);
    if (isCluster_.found(true))
    {
        sumOverRanks(resistsTurning_);
    }
}


void Foam::cutGrains::setInertia()
{
    // So much of the fluid's that a grain which is fixed hardly yields
    constexpr scalar fixed = 1e4;

    const grainMotion& motion = grains_.motion();
    const scalar deltaT = mesh_.time().deltaTValue();
    if (motion.isFixed())
    {
        inertia_ = scalarField
        (
            grains_.size(), fixed*gMax(fluid_.rho().primitiveField())/deltaT
        );
        return;
    }
    inertia_ = resists_/max(grains_.mappedVolume(), VSMALL);
    forAll(inertia_, graini)
    {
        inertia_[graini] += motion.density(graini)/deltaT;
    }
}


void Foam::cutGrains::moveGrains(volVectorField& U)
{
    setRemainder(U);
    vectorField force(grains_.size(), Zero);
    vectorField torque(grains_.size(), Zero);
    addForceOfCells(U, force, torque);
    sumOverRanks(force);
    if (isCluster_.found(true))
    {
        addMomentOfBuoyancy(torque);
        sumOverRanks(torque);
        leaveRotation(torque);
    }

    const List<grainMotion::twist> last(motion_);
    const grainMotion& motion = grains_.motion();
    const scalar deltaT = mesh_.time().deltaTValue();
    forAll(motion_, graini)
    {
        if (!isResolved(graini))
        {
            continue;
        }
        const scalar inertia = motion.mass(graini)/deltaT;
        motion_[graini].velocity =
            (
                inertia*free_[graini].velocity
              + resists_[graini]*last[graini].velocity
              + force[graini]
            )
           /(inertia + resists_[graini]);
        if (isCluster_[graini])
        {
            const tensor turning(motion.momentOfInertia(graini)/deltaT);
            const tensor& resists = resistsTurning_[graini];
            motion_[graini].spin =
                inv(turning + resists)
              & (
                    (turning & free_[graini].spin)
                  + (resists & last[graini].spin)
                  + torque[graini]
                );
        }
    }
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        const grainMotion::twist& now = motion_[x.grain];
        const grainMotion::twist& before = last[x.grain];
        U[x.cell] +=
            follows(i)
           *(
                (now.velocity - before.velocity)
              + ((now.spin - before.spin) ^ x.arm)
            );
    }
}


void Foam::cutGrains::correctMotion
(
    volVectorField& U,
    const surfaceScalarField&,
    const surfaceScalarField&
)
{
    if (!isActive())
    {
        return;
    }
    if (!grains_.motion().isFixed())
    {
        moveGrains(U);
    }
    sumLinks();
    forAll(cover_, celli)
    {
        if (cover_[celli] >= 0)
        {
            U[celli] = velocityIn(celli);
        }
    }
}
