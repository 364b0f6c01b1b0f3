/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vapourThrust.H"

#include "combineOverRanks.H"
#include "dropletTerm.H"


Foam::vapourThrust::vapourThrust(const liquidDroplets& droplets)
:
    droplets_(droplets),
    speed_
    (
        IOobject
        (
            "blowingSpeed",
            droplets.system().mesh().time().timeName(),
            droplets.system().mesh()
        ),
        droplets.system().mesh(),
        dimensionedScalar(dimVelocity, Zero)
    )
{}


void Foam::vapourThrust::set
(
    const List<vapourJet>& jets,
    const scalarField& growth,
    const volVectorField& U,
    const dropletTerm& term
)
{
    const grainSystem& system = droplets_.system();
    const scalarField& V = system.mesh().V();
    force_ = vectorField(V.size(), Zero);
    coefficient_ = scalarField(V.size(), Zero);
    thrust_ = vectorField(droplets_.size(), Zero);

    // A cell may be beside two droplets, whose faces come in any order
    scalarField rate(V.size(), Zero), area(V.size(), Zero), swelling(V.size(), Zero);
    for (const vapourJet& jet : jets)
    {
        rate[jet.cell] += jet.rate;
        area[jet.cell] += jet.area;
        swelling[jet.cell] += jet.area*growth[jet.droplet];
    }
    speed_ == dimensionedScalar(dimVelocity, Zero);
    for (const vapourJet& jet : jets)
    {
        speed_[jet.cell] =
            rate[jet.cell]
           /(droplets_.properties().vapourDensity*area[jet.cell])
          + swelling[jet.cell]/area[jet.cell];
    }
    speed_.correctBoundaryConditions();

    for (const vapourJet& jet : jets)
    {
        const grainMotion::twist motion(system.motion().motion(jet.droplet));
        if (jet.rate < 0)
        {
            // Gas that condenses has the velocity of its cell: no force on the rest
            thrust_[jet.droplet] -=
                jet.rate*(U[jet.cell] - motion.velocity);
            continue;
        }
        const vector& n = jet.normal;
        const vector relative
        (
            (motion.spin ^ (system.motion().radius(jet.droplet)*n))
          + speed_[jet.cell]*n
        );
        force_[jet.cell] += jet.rate/V[jet.cell]*(motion.velocity + relative);
        coefficient_[jet.cell] += jet.rate/V[jet.cell];
        thrust_[jet.droplet] -= jet.rate*relative;
    }
    sumOverRanks(thrust_);
    if (!term.leavesParts())
    {
        pushDroplets(term);
    }
}


void Foam::vapourThrust::pushDroplets(const dropletTerm& term)
{
    const scalarField& V = droplets_.system().mesh().V();
    scalarField volume(droplets_.size(), Zero);
    forAll(V, celli)
    {
        const label d = term.dropletOf(celli);
        if (d >= 0)
        {
            volume[d] += V[celli];
        }
    }
    sumOverRanks(volume);
    forAll(V, celli)
    {
        const label d = term.dropletOf(celli);
        if (d >= 0)
        {
            force_[celli] += thrust_[d]/volume[d];
        }
    }
}


void Foam::vapourThrust::addTo(fvVectorMatrix& UEqn) const
{
    if (force_.size())
    {
        const scalarField& V = UEqn.psi().mesh().V();
        UEqn.diag() += V*coefficient_;
        UEqn.source() += V*force_;
    }
}
