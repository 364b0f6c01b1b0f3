/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFlow.H"

#include "findRefCell.H"
#include "fvc.H"
#include "registeredLaminar.H"

namespace
{

using namespace Foam;

//- Velocity on faces with the normal component of a flux (doc/theory, eq. 2.31)
tmp<surfaceVectorField> withFlux
(
    const volVectorField& U,
    const surfaceScalarField& flux
)
{
    const fvMesh& mesh = U.mesh();
    tmp<surfaceVectorField> result(fvc::interpolate(U));
    result.ref() +=
        mesh.Sf()/sqr(mesh.magSf())*(flux - (mesh.Sf() & result()));
    return result;
}

//- A copy that a change of the mesh maps, which slices of its lists would not survive
template<class Field>
Field* registered(const word& name, const Field& x)
{
    typedef dimensioned<typename Field::value_type> value;
    const fvMesh& mesh = x.mesh();
    Field* result = new Field
    (
        IOobject(name, mesh.time().timeName(), mesh), mesh, value(x.dimensions(), Zero)
    );
    *result == x;
    return result;
}

tmp<volScalarField> cellVolumes(const fvMesh& mesh)
{
    tmp<volScalarField> result
    (
        new volScalarField
        (
            IOobject("cellVolumes", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimVolume, Zero)
        )
    );
    result.ref().primitiveFieldRef() = mesh.V();
    return result;
}

template<class Field>
void keepOldTime(const Field& x)
{
    x.oldTime();
    x.storeOldTimes();
}

}


void Foam::vansFlow::beforeMeshChange()
{
    // In the first step after a start, too: a field that is changed before its
    // old time is asked for would have the changed one as its old time
    keepOldTime(fields_.U);
    faceU_.clear();
    for (const surfaceScalarField* flux : fields_.fluxes())
    {
        keepOldTime(*flux);
        faceU_.append(withFlux(fields_.U, *flux).ptr());
    }
    if (isSecondOrderInTime(mesh_))
    {
        faceU_.append
        (
            withFlux
            (
                fields_.U.oldTime().oldTime(),
                fields_.phiMomentum.oldTime().oldTime()
            ).ptr()
        );
    }
    facesBefore_.clear();
    facesBefore_.append(registered("centresBefore", mesh_.Cf()));
    facesBefore_.append(registered("areasBefore", mesh_.Sf()));
    const volScalarField inertia(grains_.fluidShare*fluid_.rho());
    cellsBefore_.clear();
    cellsBefore_.append(registered("volumeBefore", cellVolumes(mesh_)()));
    cellsBefore_.append(registered("inertiaBefore", inertia));
    momentumBefore_.clear();
    momentumBefore_.reset
    (
        registered("momentumBefore", volVectorField(inertia*fields_.U))
    );
    step_.clear();
    UEqn_.clear();
    faces_.clear();
}


void Foam::vansFlow::keepMomentum()
{
    const scalarField& V = mesh_.V();
    const scalarField& before = cellsBefore_[0];
    const scalarField& inertia = cellsBefore_[1];
    const scalar least = 1e-6*gMax(inertia);
    forAll(V, celli)
    {
        if (V[celli] > 1.5*before[celli] && inertia[celli] > least)
        {
            const vector U(momentumBefore_()[celli]/inertia[celli]);
            fields_.U[celli] = U;
            fields_.U.oldTime()[celli] = U;
        }
    }
    cellsBefore_.clear();
    momentumBefore_.clear();
}


void Foam::vansFlow::remakeFlux
(
    const surfaceScalarField& ofU,
    surfaceScalarField& flux
) const
{
    flux = keptFaces_()*flux + (1 - keptFaces_())*ofU;
}


void Foam::vansFlow::meshChanged()
{
    gh_.reset(heightTimesGravity());
    if (laminar_)
    {
        laminar_->correct();
    }
    keepMomentum();
    fields_.U.correctBoundaryConditions();

    // The fluxes of the step's beginning, through the faces as they are now
    if (mesh_.topoChanging())
    {
        areFluxesOfU_ = true;
        const surfaceScalarField h(sqrt(mesh_.magSf()));
        keptFaces_.reset
        (
            new surfaceScalarField
            (
                pos(1e-6*h - mag(mesh_.Cf() - facesBefore_[0]))
               *pos(1e-6*mesh_.magSf() - mag(mesh_.Sf() - facesBefore_[1]))
            )
        );
        setRefCell(p_, fields_.p_rgh, control_, pRefCell_, pRefValue_);
    }
    label i = 0;
    for (surfaceScalarField* flux : fields_.fluxes())
    {
        if (mesh_.topoChanging())
        {
            remakeFlux(fvc::flux(fields_.U), flux->oldTime());
        }
        else
        {
            flux->oldTime() = mesh_.Sf() & faceU_[i++];
        }
        *flux = flux->oldTime();
    }
    if (isSecondOrderInTime(mesh_))
    {
        surfaceScalarField& flux = fields_.phiMomentum.oldTime().oldTime();
        if (mesh_.topoChanging())
        {
            remakeFlux(fvc::flux(fields_.U.oldTime().oldTime()), flux);
        }
        else
        {
            flux = mesh_.Sf() & faceU_[i];
        }
    }
    faceU_.clear();
    facesBefore_.clear();
}
