/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "undisturbedFlow.H"

#include "cellSizes.H"
#include "combineOverRanks.H"
#include "couplingOption.H"
#include "implicitDiffusion.H"
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


Foam::scalar Foam::undisturbedFlow::weight(const scalar diameterByCellSize)
{
    const scalar x = std::log2(diameterByCellSize);
    return min(max(min(2*(x + 1), (2 - x)/1.5), scalar(0)), scalar(1));
}


void Foam::undisturbedFlow::set
(
    const grainSystem& grains,
    const resolvedGrains& resolved,
    const volScalarField& eps,
    const volVectorField& U,
    const dragLaw& law,
    const scalar rho,
    const scalar mu
)
{
    isActive_ = false;
    if (width_ <= 0)
    {
        return;
    }

    scalar smallest = GREAT, largest = 0, sum = 0;
    label number = 0;
    for (label i = 0; i < grains.size(); ++i)
    {
        if (resolved.isResolved(i))
        {
            continue;
        }
        ++number;
        const scalar d = grains.fluidDiameter(i);
        smallest = min(smallest, d);
        largest = max(largest, d);
        sum += d;
    }
    isActive_ =
        largest > 0.5*cellSizeRange_.first()
     && smallest < 4*cellSizeRange_.second();

    if (!isActive_)
    {
        return;
    }

    const scalar spread = sqr(width_*sum/number)/24;
    const auto filtered = [&](const auto& x)
    {
        return implicitDiffusion(mesh_, x, spread, 1, 1e-9);
    };
    const scalarField& cellEps = eps.primitiveField();
    const vectorField& cellU = U.primitiveField();
    const vectorField& cellGradP = gradP_.primitiveField();

    const scalarField meanEps(filtered(cellEps));
    const vectorField meanU
    (
        filtered(vectorField(cellEps*cellU))
       /max(meanEps, SMALL)
    );
    vectorField excess(cellU.size(), Zero);
    if (gradientOnGrains_)
    {
        excess = filtered(cellGradP) - cellGradP;
    }

    const overlapList& overlaps = grains.overlaps();
    share_.resize(grains.size());
    coefficient_.resize(grains.size());

    // Over each grain: of 1, the cell's size, the undisturbed fluid fraction;
    // of the velocity, the undisturbed one, and the excess
    vectorField scalars(grains.size(), Zero);
    tensorField flows(grains.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for
        (
            label k = overlaps.start[graini];
            k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            scalars[graini] +=
                overlaps.volume[k]
               *vector(1, cellSize_[celli], meanEps[celli]);
            flows[graini] +=
                overlaps.volume[k]
               *tensor(cellU[celli], meanU[celli], excess[celli]);
        }
    }
    sumOverRanks(scalars);
    sumOverRanks(flows);

    forAll(share_, graini)
    {
        const scalar volume = max(scalars[graini].x(), VSMALL);
        const vector mean(scalars[graini]/volume);
        const tensor flow(flows[graini]/volume);
        const scalar d = grains.fluidDiameter(graini);

        share_[graini] = weight(d/max(mean.y(), VSMALL));
        if (share_[graini] <= 0)
        {
            continue;
        }

        // Of a grain that moves with the fluid, the law's own coefficient
        // remains
        const vector v(grains.motion().velocity(graini));
        const vector w(flow.x() - v);
        const scalar least = 1e-8*mu/(rho*d);
        const scalar slip = mag(w) + least;
        const scalar undisturbedSlip = mag(flow.y() - v);

        scalar drag =
            (undisturbedSlip + least)
           *law.gamma(mean.z(), undisturbedSlip, d, rho, mu);
        if (gradientOnGrains_)
        {
            drag = max(drag - (flow.z() & w)/slip, 0.05*drag);
        }
        else
        {
            drag /= mean.z();
        }
        coefficient_[graini] = drag/slip;
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
