/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "combineOverRanks.H"
#include "implicitInSpin.H"
#include "meanOverGrains.H"

void Foam::cutGrains::addForce
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
        if (!isResolved(graini))
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            force[graini] += weight_.forceInCell(o.volume, o.cell);
        }
    }

    vectorField torque(grains_.size(), Zero);
    addForceOfCells(U, force, torque);
}


void Foam::cutGrains::addForceOfCells
(
    const volVectorField& U,
    vectorField& force,
    vectorField& torque
) const
{
    // What the pressure gives to a disc or sphere has no moment
    const auto add = [&](const label graini, const label celli, const vector& f)
    {
        force[graini] += f;
        if (isCluster_[graini])
        {
            torque[graini] += armOf(graini, celli) ^ f;
        }
    };
    const List<cutCells::wall>& walls = cells_.walls();
    boolList hasWall(mesh_.nCells(), false);
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        hasWall[x.cell] = true;
        add
        (
            x.grain,
            x.cell,
            x.share
           *(
                pressure_[x.cell] + given_[x.cell] + remainder_[x.cell]
              + mesh_.V()[x.cell]*small_->bOfBodies[x.cell]
            )
          - resistanceInside(x)*velocityIn(x)
        );
        const vector pull(link_[i]*(U[x.cell] - velocityAt(i)));
        force[x.grain] += pull;
        torque[x.grain] += x.arm ^ pull;
        if (isCluster_[x.grain])
        {
            torque[x.grain] += x.share*moment_[x.cell];
        }
    }
    forAll(remainder_, celli)
    {
        const label graini = holder_[celli];
        if (!hasWall[celli] && graini >= 0)
        {
            add(graini, celli, remainder_[celli]);
        }
    }
}


void Foam::cutGrains::setRemainder(const volVectorField& U)
{
    const bool isSecondOrder = weights_.earlier > 0;
    const volVectorField& before = U.oldTime();
    const volVectorField& earlier = isSecondOrder ? before.oldTime() : before;
    const volScalarField& fluidBefore = fluidInTime_.oldTime();
    const volScalarField& fluidEarlier =
        isSecondOrder ? fluidBefore.oldTime() : fluidBefore;

    const scalar deltaT = mesh_.time().deltaTValue();
    const scalarField& V = mesh_.V();
    const scalarField& fluid = cells_.fluid();
    const scalarField& rho = fluid_.rho();
    const scalarField amongSmall
    (
        this->amongSmall(small_->fluidShare)().primitiveField()
    );
    forAll(remainder_, celli)
    {
        const label graini = holder_[celli];
        if (graini < 0)
        {
            continue;
        }
        const vector v
        (
            isCluster_[graini]
          ? motion_[graini].at(armOf(graini, celli))
          : motion_[graini].velocity
        );
        const scalar perShare =
            rho[celli]*V[celli]*amongSmall[celli]/deltaT;
        const scalar change =
            perShare*weights_.before*(fluid[celli] - fluidBefore[celli]);
        const scalar earlierChange =
            perShare*weights_.earlier*(fluid[celli] - fluidEarlier[celli]);

        // What flows out where small grains move has to do with them, too, and
        // beside bodies that blow with what comes out of them
        const scalar outflow =
            amongSmall[celli] < 1 || blowingSpeed_.size()
          ? earlierChange - change
          : outflow_[celli];
        remainder_[celli] =
            earlierChange*(earlier[celli] - v)
          - change*(before[celli] - v)
          - outflow*(U[celli] - v);
    }
}


Foam::vector Foam::cutGrains::forceOfCell
(
    const label celli,
    const vector& U,
    const vector& gradP
) const
{
    if (!isActive())
    {
        return Zero;
    }
    const scalar open = cells_.fluid()[celli];
    return
        pressure_[celli] + given_[celli] + remainder_[celli]
      + resistance_[celli]*U - pull_[celli]
      + (open > 0 ? (1 - open)*mesh_.V()[celli] : 0)*gradP;
}


void Foam::cutGrains::sumLinks()
{
    resistance_.resize(mesh_.nCells());
    resistance_ = Zero;
    pull_.resize(mesh_.nCells());
    pull_ = Zero;
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        resistance_[x.cell] += link_[i];
        pull_[x.cell] += link_[i]*velocityAt(i);
    }
}


void Foam::cutGrains::addMomentOfBuoyancy(vectorField& torque) const
{
    forAll(torque, graini)
    {
        if (isCluster_[graini])
        {
            for (const cellOverlap& o : grains_.overlaps().of(graini))
            {
                torque[graini] += o.arm ^ weight_.forceInCell(o.volume, o.cell);
            }
        }
    }
}


void Foam::cutGrains::leaveRotation(vectorField& torque) const
{
    const scalarField mu(meanOverGrains(grains_, fluid_.mu()));
    forAll(torque, graini)
    {
        if (isResolved(graini))
        {
            torque[graini] -=
                2*mu[graini]*grains_.mappedVolume()[graini]*motion_[graini].spin;
        }
    }
}


void Foam::cutGrains::addViscousTorque
(
    const volVectorField& U,
    const surfaceScalarField&,
    vectorField& torque
) const
{
    if (!isActive())
    {
        return;
    }
    vectorField force(grains_.size(), Zero);
    vectorField given(grains_.size(), Zero);
    addForceOfCells(U, force, given);
    addMomentOfBuoyancy(given);

    scalarField resistance(grains_.size(), Zero);
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        resistance[x.grain] += link_[i]*magSqr(x.arm);
    }
    sumOverRanks(given);
    sumOverRanks(resistance);
    leaveRotation(given);

    // Implicit in the spin of discs and spheres; that of clusters is known
    const grainMotion& motion = grains_.motion();
    const scalar deltaT = mesh_.time().deltaTValue();
    forAll(torque, graini)
    {
        if (!isResolved(graini))
        {
            continue;
        }
        torque[graini] +=
            isCluster_[graini]
          ? given[graini]
          : implicitInSpin
            (
                motion,
                graini,
                deltaT,
                given[graini],
                resistance[graini]*tensor::I
            );
    }
}
