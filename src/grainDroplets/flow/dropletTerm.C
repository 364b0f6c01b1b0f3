/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletTerm.H"

#include "cellSizes.H"
#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "implicitTransfer.H"
#include "openingExchange.H"


Foam::dropletTerm::dropletTerm
(
    const liquidDroplets& droplets,
    const grainSystem& grains,
    const thermalFluid& fluid
)
:
    droplets_(droplets),
    fluid_(fluid),
    cut_
    (
        droplets.areCut()
      ? new cutGrains
        (
            droplets.system(), fluid, droplets.fewest(),
            {droplets.dict(), "surface", "locked"}
        )
      : nullptr
    ),
    bodies_
    (
        cut_
      ? static_cast<resolvedTerm*>(cut_)
      : new lockedGrains(droplets.system(), fluid, droplets.fewest())
    ),
    inside_(grains, droplets),
    around_(fluid, droplets.properties()),
    thrust_(droplets)
{}


void Foam::dropletTerm::requireSmallGrains(const grainSystem& grains) const
{
    const dictionary& coupling = grains.motion().coupling();
    const dictionary* resolved = coupling.findDict("resolvedGrains");
    const word type
    (
        resolved ? resolved->getOrDefault<word>("type", "locked") : "none"
    );
    if (type != "none")
    {
        dictionaryInput::badValue
        (
            *resolved, "type", type,
            "none, as the flow is resolved around droplets and not around"
            " grains"
        );
    }

    const dictionary& fraction =
        dictionaryInput::subDict(coupling, "voidFraction");
    const word spread("diffused");
    if (fraction.getOrDefault<word>("type", "") == spread)
    {
        dictionaryInput::badValue
        (
            fraction, "type", spread,
            "exactOverlap, as what grains and droplets exchange is in the cells"
            " that they share"
        );
    }

    // Those that move would be thrown away where they fill cells at a cut surface
    const bool areHeld =
        grains.motion().isFixed() && droplets_.system().motion().isFixed();
    const scalar cells = cut_ && !areHeld ? 1 + 1e-6 : 4;
    const scalar most = cells*gMin(cellSizes(grains.mesh()));
    for (label i = 0; i < grains.size(); ++i)
    {
        if (grains.fluidDiameter(i) >= most)
        {
            FatalIOErrorInFunction(coupling)
                << "Keyword 'initialGrains' of constant/grainProperties: grain "
                << grains.motion().id(i) << " has a diameter of "
                << grains.fluidDiameter(i) << " m" << nl
                << "    allowed: less than " << most << ", " << label(cells)
                << " times the size of the smallest cell, as "
                << (
                       cells < 4
                     ? "it would fill cells at the surface of a droplet; or 'surface"
                       " locked' in constant/dropletProperties"
                     : "the flow is resolved around droplets and not around grains"
                   )
                << exit(FatalIOError);
        }
    }
}


void Foam::dropletTerm::update()
{
    bodies_->update();
    around_.update(*this);
}


Foam::scalar Foam::dropletTerm::fluidBeside
(
    const label celli,
    const scalar eps
) const
{
    const scalar filled = droplets_.filled(celli);
    return
        cut_
      ? max(eps - filled + inside_.inCell(celli), scalar(0))
      : eps*(1 - filled);
}


void Foam::dropletTerm::followGrains()
{
    bodies_->followGrains();
    inside_.find();
    around_.update(*this);
}


Foam::vector Foam::dropletTerm::normal
(
    const label celli,
    const label droplet
) const
{
    const grainSystem& system = droplets_.system();
    const fvMesh& mesh = system.mesh();
    const vector arm
    (
        inMesh
        (
            mesh, system.shortest(mesh.C()[celli] - system.centres()[droplet])
        )
    );
    return arm/max(mag(arm), VSMALL);
}


Foam::vector Foam::dropletTerm::atCell
(
    const grainMotion::twist& motion,
    const label droplet,
    const label celli
) const
{
    const grainSystem& system = droplets_.system();
    return motion.at
    (
        system.shortest(system.mesh().C()[celli] - system.centres()[droplet])
    );
}


Foam::vector Foam::dropletTerm::liquidVelocity(const label celli) const
{
    const label i = cut_ ? inside_.dropletIn(celli) : dropletOf(celli);
    return atCell(droplets_.system().motion().motion(i), i, celli);
}


Foam::vector Foam::dropletTerm::velocityOfLiquid(const label celli) const
{
    const label i = inside_.dropletIn(celli);
    return atCell(cut_->motionOf(i), i, celli);
}


void Foam::dropletTerm::blow
(
    const List<vapourJet>& jets,
    const scalarField& growth,
    const volVectorField& U
)
{
    thrust_.set(jets, growth, U, *this);
    bodies_->blow({thrust_.speed(), thrust_.ofAll()});
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
    bodies_->addForce(U, force);
    addForceOnSmall(U, force);
    sumOverRanks(force);
    if (cut_)
    {
        force += thrust_.ofAll();
    }
    bodies_->addViscousTorque(U, mu, torque);
    openingExchange(droplets_.system(), fluid_).extendForce
    (
        *bodies_, force, torque
    );
}


void Foam::dropletTerm::addForceOnSmall
(
    const volVectorField& U,
    vectorField& force
) const
{
    const grainSystem& system = droplets_.system();
    const grainMotion& motion = system.motion();
    const buoyancy weight(system, fluid_);
    const scalar deltaT = system.mesh().time().deltaTValue();
    const scalar factor = system.mesh().nGeometricD() == 2 ? 14.7 : 18;

    forAll(force, i)
    {
        if (!droplets_.isSmall(i) || motion.isFixed())
        {
            continue;
        }
        const scalar rho = motion.density(i);
        const vector& v = motion.velocity(i);
        for (const cellOverlap& o : system.overlaps().of(i))
        {
            const implicitTransfer<vector> drag
            (
                factor*fluid_.mu()[o.cell]/sqr(system.fluidDiameter(i)),
                deltaT, rho,
                v + deltaT*weight.of(i).acceleration(weight.rho(o.cell))
            );
            force[i] +=
                weight.forceInCell(o.volume, o.cell)
              + o.volume*drag.given(U[o.cell], Zero);
        }
    }
}


Foam::vector Foam::dropletTerm::impulseOnOthers(const volVectorField& U) const
{
    vectorField force(droplets_.size(), Zero);
    bodies_->addForce(U, force);
    vector sum(Foam::sum(force));

    const grainSystem& system = droplets_.system();
    const buoyancy weight(system, fluid_);
    for (label i = 0; i < droplets_.size(); ++i)
    {
        if (bodies_->isResolved(i))
        {
            for (const cellOverlap& o : system.overlaps().of(i))
            {
                sum -= weight.forceInCell(o.volume, o.cell);
            }
        }
    }
    return
        system.mesh().time().deltaTValue()
       *returnReduce(sum, sumOp<vector>());
}
