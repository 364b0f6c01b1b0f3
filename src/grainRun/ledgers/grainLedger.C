/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainLedger.H"

#include "fvc.H"
#include "PstreamReduceOps.H"

Foam::grainLedger::grainLedger
(
    const grainSystem& grains,
    const grainFluidExchange& exchange,
    const carriedFields& carried,
    const volVectorField& U,
    const volScalarField& rho
)
:
    grains_(grains),
    exchange_(exchange),
    carried_(carried),
    U_(U),
    rho_(rho),
    mesh_(grains.mesh()),
    progress_(mesh_.time()),
    meanCourant_(0),
    maxCourant_(0),
    momentumError_(0),
    divergence_(0),
    volumeDefect_(0),
    fluidMomentum_(Zero),
    grainMomentum_(Zero),
    grainMomentumError_(0),
    carriedUnaccounted_(0)
{
    setVolumes();

    Info<< "Grains: " << grains_.size() << ", volume " << grainVolume_
        << " m^3, of it in the mesh " << mappedVolume_ << " m^3" << endl;
}


void Foam::grainLedger::setVolumes()
{
    grainVolume_ = 0;
    mappedVolume_ = 0;
    mappingError_ = 0;
    for (label i = 0; i < grains_.size(); ++i)
    {
        const scalar V = grains_.volume(i);
        const scalar mapped = grains_.mappedVolume()[i];
        grainVolume_ += V;
        mappedVolume_ += mapped;

        if (grains_.isWithinBounds(i) && !grains_.isAtOpening(i))
        {
            mappingError_ = max(mappingError_, mag(V - mapped)/V);
        }
    }
}


void Foam::grainLedger::startStep(const surfaceScalarField& phiU)
{
    const Time& runTime = mesh_.time();
    const scalarField sumPhi(fvc::surfaceSum(mag(phiU))().primitiveField());

    maxCourant_ =
        0.5*gMax(sumPhi/mesh_.V().field())*runTime.deltaTValue();
    meanCourant_ =
        0.5*gSum(sumPhi)/gSum(mesh_.V().field())*runTime.deltaTValue();

    Info<< nl << "Time = " << runTime.timeName() << nl << endl;

    before_ = grains_.motion().tally();
    keepEps();
}


void Foam::grainLedger::keepEps()
{
    oldEps_ = exchange_.eps().primitiveField();
    // What makes room for grains that come in does so within the step
    oldMass_ = carried_.flux().oldVolume()*rho_.primitiveField();
    oldEpsf_.reset(new surfaceScalarField(fvc::interpolate(exchange_.eps())));
}


void Foam::grainLedger::endStep
(
    const surfaceScalarField& phi,
    const surfaceScalarField& phiU
)
{
    const scalar deltaT = mesh_.time().deltaTValue();

    setVolumes();

    divergence_ = deltaT*gMax(mag(fvc::div(phi)().primitiveField())());

    const scalarField inflow
    (
       -deltaT*fvc::div(oldEpsf_()*phiU)().primitiveField()
    );
    scalarField gained(exchange_.eps().primitiveField() - oldEps_ - inflow);
    if (exchange_.filled().size())
    {
        gained -= exchange_.filled();
    }
    const scalar defect = gSum(mag(gained*mesh_.V().field())());
    volumeDefect_ = grainVolume_ > 0 ? defect/grainVolume_ : 0;

    const vector given = exchange_.momentumGiven();
    const vector received = exchange_.momentumReceived();
    momentumError_ =
        grains_.size()
      ? mag(given - received)/max(mag(received), VSMALL)
      : 0;

    if (carried_.hasCarried())
    {
        carriedUnaccounted_ = carried_.unaccounted();
    }
    fluidMomentum_ = gSum((oldMass_*U_.primitiveField())());
    grainMomentum_ = grains_.motion().tally().momentum;
    closeMomentum();
    print();
    write();
}


void Foam::grainLedger::closeMomentum()
{
    const grainMotion& motion = grains_.motion();
    if (motion.isFixed())
    {
        return;
    }
    const vector change
    (
        grainMomentum_ + motion.removed().momentum
      - before_.momentum
    );
    const vector weight
    (
        before_.mass*mesh_.time().deltaTValue()*motion.g()
    );
    const vector fluid
    (
        exchange_.momentumReceived() + exchange_.impulseOutside()
    );
    const vector walls(motion.wallImpulse());
    grainMomentumError_ =
        mag(change - weight - fluid - walls)
       /max
        (
            mag(before_.momentum) + mag(weight) + mag(fluid) + mag(walls),
            VSMALL
        );
}
