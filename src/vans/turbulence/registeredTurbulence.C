/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "registeredTurbulence.H"

#include "fvc.H"

namespace
{

const Foam::geometricOneField everywhere;


//- There is one model of a name in the registry
Foam::turbulenceModel& unregistered(Foam::turbulenceModel& model)
{
    model.checkOut();
    return model;
}

}


Foam::registeredTurbulence::registeredTurbulence
(
    Foam::turbulenceModel& model,
    const surfaceScalarField& phiU,
    const incompressible::turbulenceModel::transportModel& transport
)
:
    incompressible::turbulenceModel
    (
        unregistered(model).type(),
        everywhere,
        everywhere,
        model.U(),
        phiU,
        phiU,
        transport,
        turbulenceModel::propertiesName
    ),
    model_(model)
{}


Foam::tmp<Foam::volSymmTensorField> Foam::registeredTurbulence::devReff() const
{
    return -nuEff()*dev(twoSymm(fvc::grad(U())));
}


void Foam::registeredTurbulence::correct()
{
    incompressible::turbulenceModel::correct();
    model_.correct();
}
