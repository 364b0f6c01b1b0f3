/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFlow.H"

#include "findRefCell.H"
#include "fvc.H"

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
    keepOldTime(fields_.phiU);
    keepOldTime(fields_.phiMomentum);
    keepOldTime(fields_.phi);

    faceU_.reset(withFlux(fields_.U, fields_.phiU).ptr());
    faceMomentumU_.reset(withFlux(fields_.U, fields_.phiMomentum).ptr());
    faceMixtureU_.reset(withFlux(fields_.U, fields_.phi).ptr());
    step_.clear();
    UEqn_.clear();
    faces_.clear();
}


void Foam::vansFlow::meshChanged()
{
    setHeight();
    fields_.U.correctBoundaryConditions();

    // The fluxes of the step's beginning, through the faces as they are now
    if (mesh_.topoChanging())
    {
        fields_.phiU.oldTime() = fvc::flux(fields_.U);
        fields_.phiMomentum.oldTime() = fvc::flux(fields_.U);
        fields_.phi.oldTime() = fvc::flux(fields_.U);
        areFluxesOfU_ = true;
        setRefCell(p_, fields_.p_rgh, control_, pRefCell_, pRefValue_);
    }
    else
    {
        fields_.phiU.oldTime() = mesh_.Sf() & faceU_();
        fields_.phiMomentum.oldTime() = mesh_.Sf() & faceMomentumU_();
        fields_.phi.oldTime() = mesh_.Sf() & faceMixtureU_();
    }
    fields_.phiU = fields_.phiU.oldTime();
    fields_.phiMomentum = fields_.phiMomentum.oldTime();
    fields_.phi = fields_.phi.oldTime();
    faceU_.clear();
    faceMomentumU_.clear();
    faceMixtureU_.clear();
}
