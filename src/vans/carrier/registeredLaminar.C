/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "registeredLaminar.H"

#include "fvc.H"

namespace
{

using namespace Foam;

//- The fluid fraction and density of an incompressible model
const geometricOneField& unity()
{
    static const geometricOneField one;
    return one;
}


//- constant/turbulenceProperties, empty without the file
IOdictionary turbulenceProperties(const fvMesh& mesh)
{
    return IOdictionary
    (
        IOobject
        (
            turbulenceModel::propertiesName, mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
}


//- Name of a file in constant that OpenFOAM's base class can read, empty if there is
//  none
word fileOf(const fvMesh& mesh)
{
    if (!turbulenceProperties(mesh).empty())
    {
        return turbulenceModel::propertiesName;
    }
    IOobject io("transportProperties", mesh.time().constant(), mesh);
    return io.typeHeaderOk<IOdictionary>(true) ? io.name() : word::null;
}

}


Foam::registeredLaminar::registeredLaminar
(
    const carrier& fluid,
    const volVectorField& U,
    const surfaceScalarField& phiU
)
:
    carrierViscosity(fluid),
    incompressible::turbulenceModel
    (
        "laminar", unity(), unity(), U, phiU, phiU,
        static_cast<const carrierViscosity&>(*this), fileOf(U.mesh())
    )
{
    IOdictionary& registered = *this;
    if (registered.name() != turbulenceModel::propertiesName)
    {
        registered.watchIndices().clear();
        registered.rename(turbulenceModel::propertiesName);
    }
}


Foam::autoPtr<Foam::registeredLaminar> Foam::registeredLaminar::New
(
    const carrier& fluid,
    const volVectorField& U,
    const surfaceScalarField& phiU
)
{
    return autoPtr<registeredLaminar>
    (
        fileOf(U.mesh()).size()
     && turbulenceProperties(U.mesh()).getOrDefault<word>
        (
            "simulationType", "laminar"
        ) == "laminar"
      ? new registeredLaminar(fluid, U, phiU)
      : nullptr
    );
}


const Foam::word& Foam::registeredLaminar::type() const
{
    static const word name("laminar");
    return name;
}


Foam::tmp<Foam::volScalarField> Foam::registeredLaminar::zero
(
    const word& name,
    const dimensionSet& dims
) const
{
    return volScalarField::New(name, mesh_, dimensionedScalar(dims, Zero));
}


Foam::tmp<Foam::volScalarField> Foam::registeredLaminar::nut() const
{
    return zero("nut", dimViscosity);
}


Foam::tmp<Foam::scalarField> Foam::registeredLaminar::nut(const label patchi) const
{
    return tmp<scalarField>::New(mesh_.boundary()[patchi].size(), Zero);
}


Foam::tmp<Foam::volScalarField> Foam::registeredLaminar::k() const
{
    return zero("k", sqr(dimVelocity));
}


Foam::tmp<Foam::volScalarField> Foam::registeredLaminar::epsilon() const
{
    return zero("epsilon", sqr(dimVelocity)/dimTime);
}


Foam::tmp<Foam::volSymmTensorField> Foam::registeredLaminar::R() const
{
    return volSymmTensorField::New
    (
        "R", mesh_, dimensionedSymmTensor(sqr(dimVelocity), Zero)
    );
}


Foam::tmp<Foam::volSymmTensorField> Foam::registeredLaminar::devReff() const
{
    return -nu()*dev(twoSymm(fvc::grad(U())));
}
