/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "undisturbedFlow.H"

#include "cellSections.H"
#include "cellSizes.H"
#include "combineOverRanks.H"
#include "couplingOption.H"
#include "gaussGrad.H"
#include "implicitDiffusion.H"
#include "keepUnmarked.H"
#include "missingFields.H"
#include "zeroGradientFvPatchFields.H"

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
    section_(cellSections(mesh_)),
    cellSizeRange_(gMin(cellSize_), gMax(cellSize_)),
    exact_(grains.voidFraction().resolves()),
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
    section_ = cellSections(mesh_);
    cellSizeRange_ = Pair<scalar>(gMin(cellSize_), gMax(cellSize_));
}


Foam::undisturbedFlow::diameters Foam::undisturbedFlow::ofUnresolved
(
    const grainSystem& grains,
    const resolvedTerm& resolved
)
{
    diameters result;
    label number = 0;
    for (label i = 0; i < grains.size(); ++i)
    {
        if (!resolved.isResolved(i))
        {
            const scalar d = grains.fluidDiameter(i);
            ++number;
            result.largest = max(result.largest, d);
            result.mean += d;
        }
    }
    result.mean /= max(number, 1);
    return result;
}


Foam::scalarField Foam::undisturbedFlow::inFluid
(
    const resolvedTerm& resolved,
    const label nCells
)
{
    scalarField result(nCells, 1);
    forAll(result, celli)
    {
        result[celli] = resolved.isLiquid(celli) ? 0 : 1;
    }
    if (resolved.leavesParts())
    {
        result = resolved.open()().primitiveField();
    }
    return result;
}


Foam::tmp<Foam::vectorField> Foam::undisturbedFlow::gradient
(
    const scalarField& x
) const
{
    volScalarField field
    (
        IOobject("filtered", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    field.primitiveFieldRef() = x;
    field.correctBoundaryConditions();
    return tmp<vectorField>
    (
        new vectorField
        (
            fv::gaussGrad<scalar>::gradf
            (
                linearInterpolate(field), "gradient"
            )().primitiveField()
        )
    );
}


Foam::filteredFlow Foam::undisturbedFlow::filtered
(
    const scalarField& weight,
    const volScalarField& eps,
    const volVectorField& U,
    const diameters& d
) const
{
    const scalarField& cellEps = eps.primitiveField();
    const vectorField& cellU = U.primitiveField();
    const vectorField& cellGradP = gradP_.primitiveField();

    const vectorField none(cellU.size(), Zero);
    filteredFlow result{cellEps, none, cellU, none};
    if (width_ == 0)
    {
        return result;
    }

    const auto filter = [&](const auto& x, const scalar size)
    {
        return implicitDiffusion(mesh_, x, sqr(width_*size)/24, 1, 1e-9);
    };
    const bool isWhole = gMin(weight) > 0;
    const auto mean = [&](const auto& x, const scalar size)
    {
        using field = std::decay_t<decltype(x)>;
        return
            isWhole
          ? filter(x, size)
          : field(filter(field(weight*x), size)/max(filter(weight, size), SMALL));
    };

    // A filter narrower than a few cells would not tell a grain from a bed
    const scalar wide =
        mesh_.nGeometricD() == 3 ? max(d.mean, gAverage(cellSize_)) : d.mean;
    result.eps = mean(cellEps, wide);
    result.epsJump = width_*wide/std::sqrt(24.0)*gradient(result.eps);

    if (d.largest > 0.5*cellSizeRange_.first())
    {
        const scalarField flowEps
        (
            wide > d.mean ? mean(cellEps, d.mean) : result.eps
        );
        result.U =
            mean(vectorField(cellEps*cellU), d.mean)/max(flowEps, SMALL);
        if (gradientOnGrains_)
        {
            result.gradP = mean(cellGradP, d.mean);
        }
    }
    return result;
}


void Foam::undisturbedFlow::set
(
    const grainSystem& grains,
    const resolvedTerm& resolved,
    const carrier& fluid,
    const volScalarField& eps,
    const volVectorField& U,
    const flowAtOverlaps& at,
    const dragLaw& law
)
{
    // Smaller grains have moved their cell's fluid by less than 0.6 per cent
    // of their speed.  In the plane they keep the cell's flow, and so does
    // every grain of type none, but those that cover cells.
    const scalar smallest =
        width_ == 0 ? 1 : mesh_.nGeometricD() == 3 ? 0.005 : 0.5;

    const diameters d(ofUnresolved(grains, resolved));
    isActive_ = d.largest > smallest*cellSizeRange_.first();
    if (!isActive_)
    {
        return;
    }
    const scalarField weight(inFluid(resolved, eps.size()));
    const List<flowAround> flows
    (
        flowAroundGrains
        (
            grains, fluid, weight, cellSize_, section_, eps, U, gradP_, at,
            filtered(weight, eps, U, d)
        )
    );
    corrections_ = List<correction>(grains.size());
    isFound_ = boolList(grains.size(), false);
    forAll(corrections_, i)
    {
        if (!grains.overlaps().of(i).empty())
        {
            isFound_[i] = true;
            corrections_[i] = correctionOf
            (
                flows[i],
                grains.motion().velocity(i),
                {law, grains.lawDiameter(i), flows[i].rho, flows[i].mu},
                grains.fluidDiameter(i)
            );
        }
    }
}


Foam::List<Foam::undisturbedFlow::correction> Foam::undisturbedFlow::all
(
    const label n
) const
{
    if (!isActive_)
    {
        return List<correction>(n);
    }
    List<correction> result(corrections_);
    if (!Pstream::parRun())
    {
        return result;
    }

    // The first of the ranks that have found it tells the others
    labelList teller(n, Pstream::nProcs());
    forAll(teller, i)
    {
        if (isFound_[i])
        {
            teller[i] = Pstream::myProcNo();
        }
    }
    combineOverRanks(teller, minEqOp<label>());

    correction nothing;
    nothing.slipFactor = 0;
    nothing.eps = 0;
    forAll(result, i)
    {
        if (teller[i] != Pstream::myProcNo())
        {
            result[i] = nothing;
        }
    }
    sumRecordsOverRanks(result);
    forAll(result, i)
    {
        if (teller[i] == Pstream::nProcs())
        {
            result[i] = correction();
        }
    }
    return result;
}


void Foam::undisturbedFlow::discharge(const std::vector<bool>& gone)
{
    if (isActive_ && gone.size())
    {
        keepUnmarked(corrections_, gone);
        keepUnmarked(isFound_, gone);
    }
}
