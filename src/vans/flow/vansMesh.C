/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFlow.H"

#include "findRefCell.H"
#include "fvc.H"
#include "timeScheme.H"

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
    step_.clear();
    UEqn_.clear();
    faces_.clear();
}


void Foam::vansFlow::meshChanged()
{
    gh_.reset(heightTimesGravity());
    fields_.U.correctBoundaryConditions();

    // The fluxes of the step's beginning, through the faces as they are now
    if (mesh_.topoChanging())
    {
        areFluxesOfU_ = true;
        setRefCell(p_, fields_.p_rgh, control_, pRefCell_, pRefValue_);
    }
    label i = 0;
    for (surfaceScalarField* flux : fields_.fluxes())
    {
        if (mesh_.topoChanging())
        {
            flux->oldTime() = fvc::flux(fields_.U);
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
            flux = fvc::flux(fields_.U.oldTime().oldTime());
        }
        else
        {
            flux = mesh_.Sf() & faceU_[i];
        }
    }
    faceU_.clear();
}
