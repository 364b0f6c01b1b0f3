/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transportFlux.H"

#include "cyclicFvPatch.H"
#include "fvc.H"
#include "fvm.H"
#include "globalMeshData.H"
#include "fixedValueFvPatchFields.H"
#include "gaussLaplacianScheme.H"
#include "missingFields.H"
#include "processorFvPatch.H"
#include "timeScheme.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

//- Zero where the pressure is given, no correction elsewhere
wordList patchTypes(const volScalarField& p)
{
    wordList result
    (
        p.boundaryField().size(), zeroGradientFvPatchScalarField::typeName
    );
    forAll(p.boundaryField(), patchi)
    {
        if (p.boundaryField()[patchi].fixesValue())
        {
            result[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    return result;
}


//- Is one cell beside one face of all coupled boundaries?
bool isPaired(const fvMesh& mesh)
{
    bool result = true;
    for (const fvPatch& patch : mesh.boundary())
    {
        result = result
         && (
                !patch.coupled()
             || isA<processorFvPatch>(patch)
             || isA<cyclicFvPatch>(patch)
            );
    }
    return returnReduce(result, andOp<bool>());
}


dictionary solverControls
(
    const bool keepsFactors,
    const bool isLong,
    const scalar tolerance
)
{
    dictionary result;
    result.add("solver", "PCG");
    if (keepsFactors)
    {
        result.add("preconditioner", "Cholesky");
    }
    else if (isLong)
    {
        dictionary levels;
        levels.add("preconditioner", "GAMG");
        levels.add("smoother", "symGaussSeidel");
        result.add("preconditioner", levels);
    }
    else
    {
        result.add("preconditioner", "DIC");
    }
    result.add("tolerance", tolerance);
    result.add("relTol", 0);
    return result;
}

}


Foam::transportFlux::transportFlux
(
    const volScalarField& eps,
    const surfaceScalarField& share,
    const volScalarField& p_rgh,
    const bool tracks
)
:
    mesh_(eps.mesh()),
    eps_(eps),
    tracks_(tracks),
    fraction_
    (
        IOobject
        (
            "fluidFraction",
            mesh_.time().timeName(),
            mesh_,
            tracks ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
            tracks ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
        ),
        eps + least
    ),
    X_
    (
        IOobject
        (
            "transportPotential",
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT
        ),
        mesh_,
        dimensionedScalar(dimViscosity, Zero),
        patchTypes(p_rgh)
    ),
    F_
    (
        IOobject("phiFluid", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    added_("addedToFlux", F_),
    isPaired_(isPaired(mesh_)),
    isShareLost_(false),
    defect_(0),
    correction_(0),
    withoutRoom_(0)
{
    oldVolume_ = volume();
    mesh_.setFluxRequired(X_.name());
    if (isSecondOrderInTime(mesh_))
    {
        lastShare_.reset
        (
            new surfaceScalarField
            (
                IOobject
                (
                    "phiShare",
                    mesh_.time().timeName(),
                    mesh_,
                    IOobject::READ_IF_PRESENT
                ),
                share
            )
        );
        isShareLost_ = !isThere(mesh_, lastShare_->name());
    }
    setWritten(IOobject::AUTO_WRITE);
}


void Foam::transportFlux::setWritten(const IOobject::writeOption option)
{
    X_.writeOpt() = option;
    if (lastShare_)
    {
        lastShare_->writeOpt() = option;
    }
}


void Foam::transportFlux::skip()
{
    fraction_ == eps_ + least;
    isShareLost_ = true;
    setWritten(IOobject::NO_WRITE);
}


void Foam::transportFlux::meshChanged()
{
    if (mesh_.topoChanging())
    {
        fraction_ == eps_ + least;
        oldVolume_ = volume();
        isShareLost_ = true;
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::transportFlux::openPart() const
{
    volScalarField mean("openPart", fraction_);
    mean.primitiveFieldRef() = 0.5*(volume() + oldVolume_)/mesh_.V().field();
    mean.correctBoundaryConditions();

    const surfaceScalarField isOpen
    (
        "isOpen",
        pos(fvc::interpolate(pos(mean - 2*least)) - (1 - SMALL))
    );
    return isOpen*fvc::interpolate(mean) + least;
}


bool Foam::transportFlux::hasRoom() const
{
    // Beyond, factors cost more than what they save
    const label most = mesh_.nGeometricD() == 3 ? 10000 : 100000;
    if (mesh_.moving() || mesh_.globalData().nTotalCells() > most)
    {
        return false;
    }
    return returnReduce
    (
        min(fraction_.primitiveField()) > roomy
     && min(oldVolume_/mesh_.V().field()) > roomy,
        andOp<bool>()
    );
}


Foam::scalarField Foam::transportFlux::lack
(
    const surfaceScalarField& flux,
    const scalarField& source,
    const scalarField& weight
)
{
    const scalar deltaT = mesh_.time().deltaTValue();
    const scalarField room(volume());
    scalarField result
    (
        fvc::surfaceIntegrate(flux)().primitiveField()*mesh_.V().field()
      + (room - oldVolume_)/deltaT
      - source*mesh_.V().field()
    );

    source_ = source;
    withoutRoom_ = 0;
    if (X_.needReference())
    {
        const scalar excess = gSum(result);
        scalarField spread(room);
        if (weight.size())
        {
            spread *= weight;
        }
        scalar total = gSum(spread);
        if (total < least*gSum(room))
        {
            spread = room;
            total = gSum(room);
        }
        spread *= excess/total;
        result -= spread;
        source_ += spread/mesh_.V().field();
        withoutRoom_ = -excess*deltaT;
    }
    return result;
}


Foam::scalar Foam::transportFlux::defectOf(const scalarField& lack) const
{
    const scalarField& V = mesh_.V().field();
    return
        gMax(mag(lack)/(tracks_ ? volume() : V))*mesh_.time().deltaTValue();
}


void Foam::transportFlux::set
(
    const surfaceScalarField& share,
    const scalarField& source,
    const scalarField& weight,
    const scalar ofFraction
)
{
    // Of the volume of a cell, or of the fluid in it.  Where no grain is, all of it
    // is what the pressure has left of divergence.
    const bool isAlone = !mesh_.moving() && gMin(eps_.primitiveField()) >= 1;
    const scalar tolerance = tracks_ ? (isAlone ? 1e-5 : 1e-7) : ofFraction;

    setWritten(IOobject::AUTO_WRITE);
    fraction_.oldTime();
    fraction_ == eps_ + least;

    const bool keepsMatrix = hasRoom();

    // Iterations of DIC grow with the number of cells along the mesh: there were 767 in
    // a plane of 184 320, where GAMG took 14, each of which takes as long as ten
    const scalar cells = mesh_.globalData().nTotalCells();
    const bool isLong = pow(cells, 1.0/mesh_.nGeometricD()) > 100;
    const surfaceScalarField open
    (
        "open",
        keepsMatrix
      ? tmp<surfaceScalarField>(mesh_.magSf())
      : openPart()*mesh_.magSf()
    );
    F_ = share;
    if (lastShare_)
    {
        if (!isShareLost_)
        {
            F_ = 0.5*(share + *lastShare_);
        }
        *lastShare_ == share;
        isShareLost_ = false;
    }
    added_ = -F_;
    scalarField missing(lack(F_, source, weight));

    // Corrections of the correction take away what the linear solver left
    scalarField X(X_.primitiveField());
    // Where X is zero if no boundary gives it: in a cell that is open
    const label fixed =
        !Pstream::master() ? -1
      : keepsMatrix ? 0
      : findMax(fraction_.primitiveField());

    defect_ = defectOf(missing);
    for (label i = 0; i < 6 && defect_ > tolerance; ++i)
    {
        tmp<fvScalarMatrix> tXEqn
        (
            fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
            (
                open, mesh_.nonOrthDeltaCoeffs(), X_
            )
        );
        fvScalarMatrix& XEqn = tXEqn.ref();
        XEqn.source() += missing;
        XEqn.setReference(fixed, 0);
        // The largest residual of a cell is above the mean that solvers see
        XEqn.solve
        (
            solverControls
            (
                keepsMatrix && isPaired_, isLong,
                min(max(0.02*tolerance/defect_, scalar(1e-14)), scalar(0.02))
            )
        );
        F_ -= XEqn.flux();
        if (i == 0)
        {
            X = X_.primitiveField();
        }
        missing = lack(F_, source, weight);
        defect_ = defectOf(missing);
        X_.primitiveFieldRef() = 0;
        X_.correctBoundaryConditions();
    }
    X_.primitiveFieldRef() = X;
    X_.correctBoundaryConditions();
    if (tracks_)
    {
        fraction_.primitiveFieldRef() -=
            missing*mesh_.time().deltaTValue()/mesh_.V().field();
        fraction_.correctBoundaryConditions();
    }

    added_ += F_;
    correction_ =
        0.5*mesh_.time().deltaTValue()
       *gSum
        (
            fvc::surfaceSum(mag(added_))().primitiveField()
        )
       /gSum(volume());
}
