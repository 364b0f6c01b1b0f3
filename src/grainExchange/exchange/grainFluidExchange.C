/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "labelVector.H"
#include "missingFields.H"
#include "zeroGradientFvPatchFields.H"

bool Foam::grainFluidExchange::readForm(const dictionary& dict)
{
    return
        dictionaryInput::getWordOrDefault(dict, "form", "A", {"A", "B"}) == "A";
}


Foam::grainFluidExchange::grainFluidExchange
(
    grainSystem& grains,
    const carrier& fluid
)
:
    grainFluidExchange
    (
        grains, fluid, fluid, resolvedTerm::New(grains, fluid)
    )
{}


Foam::grainFluidExchange::grainFluidExchange
(
    grainSystem& grains,
    const carrier& fluid,
    const carrier& aroundGrains,
    autoPtr<resolvedTerm> resolved
)
:
    grains_(grains),
    mesh_(grains.mesh()),
    aroundGrains_(aroundGrains),
    weight_(grains, aroundGrains),
    lubrication_(lubricationLaw::New(grains.motion().coupling())),
    eps_
    (
        IOobject
        (
            "eps",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar("eps", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    overfull_(0),
    fields_
    (
        mesh_,
        readForm(grains.motion().coupling()),
        grains.pressureDiffusion()
    ),
    unresolved_(grains, aroundGrains, fields_.gradientOnGrains),
    resolved_(std::move(resolved)),
    openings_(grains, fluid),
    crossing_(grains),
    givenVelocities_
    (
        &fluid == &aroundGrains ? "Grains" : "Droplets or grains",
        grains.motion().isFixed() && &fluid == &aroundGrains
    ),
    given_(Zero),
    received_(Zero),
    hasStep_
    (
        grains.motion().lastTimeStep() > 0 && isThere(mesh_, eps_.name())
    )
{
    if (&fluid != &aroundGrains)
    {
        epsAmongGrains_.reset(new volScalarField("epsAmongGrains", eps_));
        epsAmongGrains_->writeOpt() = IOobject::NO_WRITE;
    }
    setEps();
}


void Foam::grainFluidExchange::setEps()
{
    scalarField solid(mesh_.nCells(), Zero);
    for (const cellOverlap& o : grains_.overlaps().all())
    {
        solid[o.cell] += o.volume;
    }
    solid /= mesh_.V().field();
    grains_.voidFraction().smooth(solid);

    overfull_ = 0;
    forAll(solid, celli)
    {
        const scalar room = 1 - solid[celli];
        eps_[celli] = max(room, scalar(0));
        overfull_ += max(-room, scalar(0))*mesh_.V()[celli];
    }
    reduce(overfull_, sumOp<scalar>());
    resolved_->followOverlaps();
    if (epsAmongGrains_)
    {
        *epsAmongGrains_ == eps_;
        epsAmongGrains_->correctBoundaryConditions();
        forAll(eps_, celli)
        {
            eps_[celli] = resolved_->fluidBeside(celli, eps_[celli]);
        }
    }
    eps_.correctBoundaryConditions();
}


Foam::tmp<Foam::volVectorField> Foam::grainFluidExchange::seenByGrains
(
    const volVectorField& x
) const
{
    if (!grains_.voidFraction().smooths())
    {
        return tmp<volVectorField>(x);
    }
    tmp<volVectorField> result(new volVectorField(x.name() + "Seen", x));
    grains_.voidFraction().smooth(result.ref().primitiveFieldRef());
    result.ref().correctBoundaryConditions();
    return result;
}


void Foam::grainFluidExchange::setShares()
{
    if (!resolved_->isActive())
    {
        fields_.fluidShare == epsAmongGrains();
        return;
    }

    const overlapList& overlaps = grains_.overlaps();
    volScalarField& share = fields_.fluidShare;
    share == resolved_->open();
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (resolved_->isResolved(graini))
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            share[o.cell] -=
                (1 - resolved_->inLiquid(o))*o.volume/mesh_.V()[o.cell];
        }
    }

    // What small grains fill of a locked cell they take of the resolved one, whose
    // share of the pressure is theirs there (doc/theory, eq. 3.32)
    forAll(share, celli)
    {
        const scalar excess = max(-share[celli], scalar(0));
        share[celli] += excess;
        fields_.kappa[celli] -= resolved_->isLiquid(celli) ? 0 : excess;
    }
    share.correctBoundaryConditions();
}


void Foam::grainFluidExchange::followGrains()
{
    resolved_->followGrains();
    setShares();
}


void Foam::grainFluidExchange::tellTreatment()
{
    if (hasTold_ || !grains_.size())
    {
        return;
    }
    hasTold_ = true;

    // Ranks without overlaps of a grain do not know more than zero
    List<labelVector> treatments(grains_.size(), Zero);
    forAll(treatments, i)
    {
        const bool isResolved = resolved_->isResolved(i);
        const undisturbedFlow::correction c(unresolved_.undisturbed().of(i));
        treatments[i] = labelVector
        (
            isResolved, !isResolved && c.share > 0, !isResolved && c.covers
        );
    }
    combineOverRanks(treatments, maxEqOp<labelVector>());

    const labelVector number(sum(treatments));
    const label nResolved = number.x();
    const label nUndisturbed = number.y();
    const label nOfCells = grains_.size() - nResolved - nUndisturbed;
    const label nCover = number.z();
    Info<< "Treatment of the grains: " << nResolved << " resolved, "
        << nUndisturbed << " by a law in the flow undisturbed by them, "
        << nOfCells << " in that of their cells; " << nCover
        << " cover cells without being resolved" << endl;
}


Foam::tmp<Foam::volScalarField> Foam::grainFluidExchange::epsOfLaws() const
{
    return
        resolved_->leavesParts() && !epsAmongGrains_
      ? resolved_->amongSmall(fields_.fluidShare)
      : tmp<volScalarField>(epsAmongGrains());
}


void Foam::grainFluidExchange::predictOnce(const volVectorField& cellU)
{
    const tmp<volVectorField> U(seenByGrains(cellU));

    fields_.clear();
    resolved_->update();
    setShares();
    unresolved_.predict(epsOfLaws()(), U(), *resolved_, fields_);
}


void Foam::grainFluidExchange::predict(const volVectorField& U)
{
    const stopwatch::lap lap(time_);

    predictOnce(U);
    if (!hasStep_ && !grains_.motion().isFixed())
    {
        foreseeContacts(U);
        predictOnce(U);
    }
    hasStep_ = true;
    tellTreatment();
    givenVelocities_.look(U, fields_.fluidShare);
    resolved_->addInertia(fields_);
    fields_.smooth(grains_.voidFraction());
    fields_.correctBoundaryConditions();
}


void Foam::grainFluidExchange::meshChanged()
{
    const stopwatch::lap lap(time_);
    grains_.meshChanged();
    crossing_.meshChanged();
    unresolved_.meshChanged();
    resolved_->meshChanged();
    setEps();
}


void Foam::grainFluidExchange::inject(const volVectorField& U)
{
    const stopwatch::lap lap(time_);
    fields_.freePatches = openings_.freePatches(U, resolved_->openings());
    crossing_.startStep(fields_.freePatches);
    if (grains_.inject(U))
    {
        setEps();
    }
}
