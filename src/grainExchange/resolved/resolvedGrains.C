/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "cellSizes.H"
#include "combineOverRanks.H"
#include "resolvedBySize.H"

Foam::resolvedGrains::resolvedGrains
(
    const grainSystem& grains,
    const carrier& fluid,
    const scalar from
)
:
    grains_(grains),
    mesh_(grains.mesh()),
    fluid_(fluid),
    from_(from),
    cellSize_(cellSizes(mesh_)),
    smallestCell_(gMin(cellSize_)),
    isActive_(false),
    grain_
    (
        IOobject("grainOfCell", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("none", dimless, -1)
    ),
    locked_
    (
        IOobject("locked", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    ),
    lockedFaces_
    (
        IOobject("lockedFaces", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    ),
    openCells_
    (
        IOobject("openCells", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1)
    ),
    conductance_
    (
        IOobject("conductance", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1)
    ),
    wallJump_
    (
        IOobject("wallJump", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimVelocity, Zero)
    ),
    rigidity_
    (
        IOobject("rigidity", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimDynamicViscosity, Zero)
    )
{}


void Foam::resolvedGrains::lockCells()
{
    const overlapList& overlaps = grains_.overlaps();

    grain_ == dimensionedScalar("none", dimless, -1);
    locked_ == dimensionedScalar(dimless, Zero);

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        if (!isResolved_[graini])
        {
            continue;
        }
        for (const cellOverlap& o : overlaps.of(graini))
        {
            const point& x = mesh_.C()[o.cell];
            const scalar d = depth(graini, x);
            const label other = grain(o.cell);

            if (d > 0 && (other < 0 || d > depth(other, x)))
            {
                grain_[o.cell] = graini;
                locked_[o.cell] = 1;
            }
        }
    }
    grain_.correctBoundaryConditions();
    locked_.correctBoundaryConditions();
    openGaps();

    // One of few cells, or in slender ones, may have the centre of none
    scalarField cells(grains_.size(), Zero);
    forAll(locked_, celli)
    {
        if (locked_[celli] > 0)
        {
            cells[grain(celli)] += 1;
        }
    }
    sumOverRanks(cells);
    forAll(cells, graini)
    {
        isResolved_[graini] = isResolved_[graini] && cells[graini] > 0;
    }
}


void Foam::resolvedGrains::setDensity()
{
    if (grains_.motion().isFixed())
    {
        // Times what a cell of fluid has of inertia and viscous resistance
        constexpr scalar held = 1e4;

        const scalar viscous =
            gMax(fluid_.mu().primitiveField())*mesh_.time().deltaTValue()
           /sqr(smallestCell_);
        const scalar rho = gMax(fluid_.rho().primitiveField());
        density_ = scalarField(grains_.size(), held*(rho + viscous));
        return;
    }

    density_ = scalarField(grains_.size(), Zero);
    forAll(locked_, celli)
    {
        if (locked_[celli] > 0)
        {
            density_[grain(celli)] += mesh_.V()[celli];
        }
    }
    sumOverRanks(density_);

    forAll(density_, graini)
    {
        density_[graini] =
            grains_.motion().density(graini)*grains_.mappedVolume()[graini]
           /max(density_[graini], VSMALL);
    }
}


void Foam::resolvedGrains::meshChanged()
{
    cellSize_ = cellSizes(mesh_);
    smallestCell_ = gMin(cellSize_);
    isActive_ = false;
    grain_ == dimensionedScalar("none", dimless, -1);
    locked_ == dimensionedScalar(dimless, Zero);
    setFaces();
}


void Foam::resolvedGrains::update()
{
    const bool wasActive = isActive_;

    isActive_ = false;
    for (label i = 0; i < grains_.size(); ++i)
    {
        isActive_ =
            isActive_
         || grains_.fluidDiameter(i) > from_*smallestCell_;
    }

    if (isActive_)
    {
        isResolved_ = resolvedBySize(grains_, cellSize_, from_);
        lockCells();
        setDensity();
        setFaces();
    }
    else if (wasActive)
    {
        setFaces();
        grain_ == dimensionedScalar("none", dimless, -1);
        locked_ == dimensionedScalar(dimless, Zero);
    }
}


Foam::grainMember Foam::resolvedGrains::deepestMember
(
    const label graini,
    const point& x
) const
{
    scalar deepest = -GREAT;
    grainMember result;
    for (const grainMember& body : grains_.members(graini))
    {
        const scalar d = body.radius - mag(between(body.centre, x));
        if (d > deepest)
        {
            deepest = d;
            result = body;
        }
    }
    return result;
}


Foam::scalar Foam::resolvedGrains::depth
(
    const label graini,
    const point& x
) const
{
    const grainMember body(deepestMember(graini, x));
    return body.radius - mag(between(body.centre, x));
}
