/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transportedMass.H"

#include "exchangeFields.H"
#include "missingFields.H"
#include "surfaceInterpolate.H"
#include "timeScheme.H"

namespace
{

using namespace Foam;

IOobject restartField(const fvMesh& mesh, const char* name)
{
    return IOobject
    (
        name, mesh.time().timeName(), mesh, IOobject::READ_IF_PRESENT
    );
}

}


Foam::transportedMass::transportedMass(const fvMesh& mesh)
:
    mesh_(mesh),
    isSecondOrder_(isSecondOrderInTime(mesh)),
    before_
    (
        restartField(mesh, "massBefore"),
        mesh,
        dimensionedScalar(dimDensity, Zero)
    ),
    moved_
    (
        restartField(mesh, "massMoved"),
        mesh,
        dimensionedScalar(dimMass, Zero)
    )
{
    know(isThere(mesh, before_.name()) && isThere(mesh, moved_.name()));
}


void Foam::transportedMass::know(const bool isKnown)
{
    isKnown_ = isKnown;
    const auto option = isKnown ? IOobject::AUTO_WRITE : IOobject::NO_WRITE;
    before_.writeOpt() = option;
    moved_.writeOpt() = option;
}


Foam::tmp<Foam::volScalarField> Foam::transportedMass::isCarried
(
    const volScalarField& share
) const
{
    // With the grains that came in at the beginning of the step
    const volScalarField& eps = mesh_.lookupObject<volScalarField>("eps");
    return pos(1e-6 - mag(share - max(eps, exchangeFields::epsMin)));
}


Foam::tmp<Foam::volScalarField> Foam::transportedMass::inertia
(
    const volScalarField& share,
    const volScalarField& rho
) const
{
    if (!isKnown_ || isSecondOrder_)
    {
        return share*rho;
    }
    const volScalarField carried(isCarried(share));
    return
        carried*max(before_, exchangeFields::epsMin*rho)
      + (1 - carried)*share*rho;
}


Foam::tmp<Foam::surfaceScalarField> Foam::transportedMass::flux
(
    const volScalarField& share,
    const tmp<surfaceScalarField>& other
) const
{
    tmp<surfaceScalarField> tflux
    (
        new surfaceScalarField(other().name(), other)
    );
    if (isKnown_)
    {
        const surfaceScalarField carried
        (
            pos(fvc::interpolate(isCarried(share)) - (1 - SMALL))
        );
        // What it moved in its step it moves in this one
        const surfaceScalarField flux(moved_/mesh_.time().deltaT());
        if (!isSecondOrder_)
        {
            tflux.ref() *= 1 - carried;
        }
        tflux.ref() += carried*flux;
    }
    return tflux;
}


void Foam::transportedMass::set
(
    const scalarField& before,
    const surfaceScalarField& flux
)
{
    before_.primitiveFieldRef() = before;
    before_.correctBoundaryConditions();
    moved_ = flux*mesh_.time().deltaT();
    know(true);
}
