/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "cellSizes.H"
#include "dictionaryInput.H"
#include "fvc.H"
#include "motionInStep.H"
#include "PstreamReduceOps.H"
#include "resolvedBySize.H"
#include "zeroGradientFvPatchFields.H"

Foam::cutGrains::cutGrains
(
    const grainSystem& grains,
    const carrier& fluid,
    const scalar from,
    const choice& chosen
)
:
    grains_(grains),
    mesh_(grains.mesh()),
    fluid_(fluid),
    weight_(grains, fluid),
    from_(from),
    chosen_(chosen),
    cells_(grains),
    isActive_(false),
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
    fluidInTime_
    (
        IOobject
        (
            "cutFluid", mesh_.time().timeName(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", dimless, -1),
        zeroGradientFvPatchScalarField::typeName
    ),
    lastGrain_
    (
        IOobject
        (
            "cutGrain", mesh_.time().timeName(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", dimless, -1),
        zeroGradientFvPatchScalarField::typeName
    ),
    cover_(mesh_.nCells(), -1),
    small_(nullptr),
    amongSmall_
    (
        IOobject("amongSmall", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1)
    )
{
    if (mesh_.dynamic())
    {
        refuse("a mesh that moves");
    }
    if (mesh_.nGeometricD() == 3 && !facesArePlane())
    {
        refuse("faces that are not plane");
    }
    if (grains.motion().coupling().getOrDefault<word>("form", "A") != "A")
    {
        refuse("form B");
    }
    if (fluid.wallDrag().valid())
    {
        refuse("the drag of plates");
    }
    findResolved();
    requireShortSteps();
}


bool Foam::cutGrains::facesArePlane() const
{
    // What is open of the faces of a cell would not enclose what is fluid of it
    constexpr scalar least = 1e-6;

    bool arePlane = true;
    forAll(mesh_.faces(), facei)
    {
        const vector& S = mesh_.faceAreas()[facei];
        for (const label pointi : mesh_.faces()[facei])
        {
            const vector x(mesh_.points()[pointi] - mesh_.faceCentres()[facei]);
            arePlane = arePlane && mag(x & S) <= least*mag(S)*mag(x);
        }
    }
    return returnReduce(arePlane, andOp<bool>());
}


void Foam::cutGrains::refuse(const string& what) const
{
    dictionaryInput::badValue
    (
        chosen_.dict, chosen_.keyword, "cutCells", chosen_.others + ", with " + what
    );
}


void Foam::cutGrains::findResolved()
{
    isResolved_ = resolvedBySize(grains_, cellSizes(mesh_), from_);
    isActive_ = isResolved_.found(true);
    isCluster_ = isResolved_;
    forAll(isCluster_, graini)
    {
        isCluster_[graini] =
            isResolved_[graini] && grains_.members(graini).size() > 1;
    }
    requireServed();
}


void Foam::cutGrains::requireServed() const
{
    forAll(isResolved_, graini)
    {
        if (!isResolved_[graini])
        {
            continue;
        }
        if (grains_.isAtOpening(graini))
        {
            refuse("grains that pass an opening");
        }
        // What is closed of a patch is the patch's: fluid beside it could not go away
        constexpr scalar most = 1e-3;
        if
        (
            !grains_.motion().isFixed()
         && grains_.mappedVolume()[graini] > 0
         && grains_.mappedVolume()[graini] < (1 - most)*grains_.volume(graini)
        )
        {
            refuse("bodies that move beyond the mesh: they need 'walls'");
        }
    }
}


void Foam::cutGrains::requireShortSteps() const
{
    // 20 was unstable, 5 was not with three corrections; with grains that do not
    // move 20 with two, 50 not with four
    constexpr scalar mostMoving = 1, mostFixed = 5;
    constexpr label enough = 4;

    const bool isFixed = grains_.motion().isFixed();
    const dictionary& piso = mesh_.solutionDict().subOrEmptyDict("PISO");
    if
    (
        !grains_.size()
     || (isFixed && piso.getOrDefault<label>("nCorrectors", 1) >= enough)
    )
    {
        return;
    }
    const scalar most = isFixed ? mostFixed : mostMoving;
    const scalarField nu
    (
        fluid_.mu().primitiveField()/fluid_.rho().primitiveField()
    );
    const scalar largest =
        mesh_.time().deltaTValue()*gMax(nu/sqr(cellSizes(mesh_)()));
    if (largest > most)
    {
        refuse
        (
            word(isFixed ? "fixed grains" : "grains that move")
          + " and nu deltaT/h^2 = " + Foam::name(largest) + " > "
          + Foam::name(most) + ": a smaller deltaT in system/controlDict"
          + (isFixed ? " or nCorrectors 4 in system/fvSolution" : "")
        );
    }
}


void Foam::cutGrains::findHolders()
{
    Map<label> index(2*grains_.size());
    forAll(isResolved_, graini)
    {
        if (isResolved_[graini])
        {
            index.insert(grains_.motion().id(graini), graini);
        }
    }
    holder_.resize(mesh_.nCells());
    forAll(holder_, celli)
    {
        holder_[celli] = index.lookup(label(lastGrain_[celli]), -1);
    }
    lastGrain_ == dimensionedScalar("none", dimless, -1);
    for (const cutCells::wall& x : cells_.walls())
    {
        holder_[x.cell] = x.grain;
        lastGrain_[x.cell] = grains_.motion().id(x.grain);
    }
    lastGrain_.correctBoundaryConditions();
}


void Foam::cutGrains::update()
{
    const boolList before(isResolved_);
    findResolved();
    requireShortSteps();
    cells_.update(isResolved_);
    // One that is resolved from now on, or no longer, has not come or gone
    const bool isFirst =
        gMin(fluidInTime_.primitiveField()) < 0
     || (before.size() == isResolved_.size() && before != isResolved_);
    fluidInTime_.oldTime();
    fluidInTime_ == cells_.fluid();
    if (isFirst)
    {
        fluidInTime_.oldTime() == cells_.fluid();
    }
    weights_ = weightsInTime(mesh_, fluidInTime_.nOldTimes() > 1);
    if (isSecondOrderInTime(mesh_))
    {
        fluidInTime_.oldTime().oldTime();
    }
    findHolders();

    outflow_.resize(mesh_.nCells());
    outflow_ = Zero;
    remainder_.resize(mesh_.nCells());
    remainder_ = Zero;
    gradient_.clear();
    A_.clear();
    left_.clear();
    moving_.clear();
    pressure_.resize(mesh_.nCells());
    pressure_ = Zero;
    given_.resize(mesh_.nCells());
    given_ = Zero;
    moment_.resize(mesh_.nCells());
    moment_ = Zero;

    const List<cutCells::wall>& walls = cells_.walls();
    const scalarField& open = cells_.fluid();
    link_.resize(walls.size());
    hold_.resize(mesh_.nCells());
    hold_ = Zero;
    cover_.resize(mesh_.nCells());
    cover_ = -1;
    forAll(walls, i)
    {
        const cutCells::wall& x = walls[i];
        const bool isCut = open[x.cell] > 0;
        link_[i] = linkOfLine(i);
        if (!isCut && cover_[x.cell] < 0)
        {
            cover_[x.cell] = x.grain;
            hold_[x.cell] =
                mesh_.V()[x.cell]*fluid_.rho()[x.cell]
               /mesh_.time().deltaTValue();
        }
    }

    blowingSpeed_.clear();
    setFreeMotion();
    sumLinks();
}


void Foam::cutGrains::blow(const blowing& x)
{
    blowingSpeed_ = x.speed.primitiveField();
    if (grains_.motion().isFixed())
    {
        return;
    }
    forAll(free_, graini)
    {
        free_[graini].velocity +=
            mesh_.time().deltaTValue()*x.thrust[graini]
           /grains_.motion().mass(graini);
    }
}


Foam::vector Foam::cutGrains::velocityIn(const label celli) const
{
    const label graini = cover_[celli];
    return motion_[graini].at(armOf(graini, celli));
}


void Foam::cutGrains::addInertia(exchangeFields& fields)
{
    small_ = &fields;
    amongSmall_ = fvc::interpolate(fields.fluidShare)/cells_.fluidOfFaces();
    forAll(cover_, celli)
    {
        if (cover_[celli] >= 0)
        {
            fields.kappa[celli] += 1;
        }
    }
}
