/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "undisturbedFlow.H"

#include "cellSizes.H"
#include "couplingOption.H"
#include "implicitDiffusion.H"
#include "meanOverGrains.H"
#include "missingFields.H"

Foam::undisturbedFlow::undisturbedFlow
(
    const grainSystem& grains,
    const bool gradientOnGrains
)
:
    mesh_(grains.mesh()),
    width_
    (
        couplingOption
        (
            grains.motion().coupling(), "undisturbedFlow", "filtered",
            {"width", 4, 1, 20}, !grains.voidFraction().smooths()
        ).value_or(0)
    ),
    gradientOnGrains_(gradientOnGrains),
    cellSize_(cellSizes(mesh_)),
    cellSizeRange_(gMin(cellSize_), gMax(cellSize_)),
    isActive_(false),
    gradP_
    (
        IOobject
        (
            "gradP_rgh",
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            width_ > 0 ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedVector(dimPressure/dimLength, Zero)
    )
{
    if (width_ > 0)
    {
        reportMissingFields(mesh_, {gradP_.name()}, "zero in the first step");
    }
}


void Foam::undisturbedFlow::meshChanged()
{
    cellSize_ = cellSizes(mesh_);
    cellSizeRange_ = Pair<scalar>(gMin(cellSize_), gMax(cellSize_));
}


Foam::scalar Foam::undisturbedFlow::weight(const scalar diameterByCellSize)
{
    const scalar x = std::log2(diameterByCellSize);
    return min(max(min(2*(x + 1), (2 - x)/1.5), scalar(0)), scalar(1));
}


bool Foam::undisturbedFlow::matters
(
    const grainSystem& grains,
    const resolvedTerm& resolved,
    scalar& meanDiameter
) const
{
    scalar smallest = GREAT, largest = 0, sum = 0;
    label number = 0;
    for (label i = 0; i < grains.size(); ++i)
    {
        if (!resolved.isResolved(i))
        {
            const scalar d = grains.fluidDiameter(i);
            ++number;
            smallest = min(smallest, d);
            largest = max(largest, d);
            sum += d;
        }
    }
    meanDiameter = sum/max(number, 1);
    return
        width_ > 0
     && largest > 0.5*cellSizeRange_.first()
     && smallest < 4*cellSizeRange_.second();
}


Foam::undisturbedFlow::neighbourhood Foam::undisturbedFlow::filtered
(
    const volScalarField& eps,
    const volVectorField& U,
    const scalar meanDiameter
) const
{
    const scalar spread = sqr(width_*meanDiameter)/24;
    const auto filter = [&](const auto& x)
    {
        return implicitDiffusion(mesh_, x, spread, 1, 1e-9);
    };
    const scalarField& cellEps = eps.primitiveField();
    const vectorField& cellGradP = gradP_.primitiveField();

    neighbourhood result;
    result.eps = filter(cellEps);
    result.U =
        filter(vectorField(cellEps*U.primitiveField()))/max(result.eps, SMALL);
    result.excessGradP = vectorField(U.size(), Zero);
    if (gradientOnGrains_)
    {
        result.excessGradP = filter(cellGradP) - cellGradP;
    }
    return result;
}


Foam::List<Foam::undisturbedFlow::flowAround> Foam::undisturbedFlow::around
(
    const grainSystem& grains,
    const volVectorField& U,
    const neighbourhood& flow
) const
{
    const overlapList& overlaps = grains.overlaps();
    List<flowAround> result(grains.size());
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        flowAround& sum = result[graini];
        for (const cellOverlap& o : overlaps.of(graini))
        {
            sum.volume += o.volume;
            sum.cellSize += o.volume*cellSize_[o.cell];
            sum.eps += o.volume*flow.eps[o.cell];
            sum.U += o.volume*U[o.cell];
            sum.undisturbedU += o.volume*flow.U[o.cell];
            sum.excessGradP += o.volume*flow.excessGradP[o.cell];
        }
    }
    sumRecordsOverRanks(result);

    for (flowAround& mean : result)
    {
        const scalar volume = max(mean.volume, VSMALL);
        mean.cellSize /= volume;
        mean.eps /= volume;
        mean.U /= volume;
        mean.undisturbedU /= volume;
        mean.excessGradP /= volume;
    }
    return result;
}


Foam::scalar Foam::undisturbedFlow::coefficient
(
    const flowAround& flow,
    const vector& v,
    const scalar d,
    const dragLaw& law,
    const scalar rho,
    const scalar mu
) const
{
    // Of a grain that moves with the fluid, the law's own coefficient remains
    const vector w(flow.U - v);
    const scalar least = 1e-8*mu/(rho*d);
    const scalar slip = mag(w) + least;
    const scalar undisturbedSlip = mag(flow.undisturbedU - v);

    scalar drag =
        (undisturbedSlip + least)
       *law.gamma(flow.eps, undisturbedSlip, d, rho, mu);
    if (gradientOnGrains_)
    {
        drag = max(drag - (flow.excessGradP & w)/slip, 0.05*drag);
    }
    else
    {
        drag /= flow.eps;
    }
    return drag/slip;
}


void Foam::undisturbedFlow::set
(
    const grainSystem& grains,
    const resolvedTerm& resolved,
    const carrier& fluid,
    const volScalarField& eps,
    const volVectorField& U,
    const dragLaw& law
)
{
    scalar meanDiameter;
    isActive_ = matters(grains, resolved, meanDiameter);
    if (!isActive_)
    {
        return;
    }
    const List<flowAround> flows
    (
        around(grains, U, filtered(eps, U, meanDiameter))
    );
    const scalarField rho(meanOverGrains(grains, fluid.rho()));
    const scalarField mu(meanOverGrains(grains, fluid.mu()));

    share_.resize(grains.size());
    coefficient_.resize(grains.size());
    forAll(share_, graini)
    {
        const flowAround& flow = flows[graini];
        const scalar d = grains.fluidDiameter(graini);

        share_[graini] = weight(d/max(flow.cellSize, VSMALL));
        if (share_[graini] > 0)
        {
            coefficient_[graini] = coefficient
            (
                flow, grains.motion().velocity(graini), d, law,
                rho[graini], mu[graini]
            );
        }
    }
}


Foam::scalar Foam::undisturbedFlow::corrected
(
    const scalar gamma,
    const label graini
) const
{
    const scalar share = isActive_ ? share_[graini] : 0;
    return
        share <= 0
      ? gamma
      : std::pow(coefficient_[graini], share)*std::pow(gamma, 1 - share);
}
