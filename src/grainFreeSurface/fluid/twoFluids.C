/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoFluids.H"

#include "coupledPatches.H"
#include "exchangeFields.H"
#include "fvc.H"
#include "IOdictionary.H"
#include "upwind.H"

namespace
{

Foam::IOobject restartField(const Foam::fvMesh& mesh, const char* name)
{
    using namespace Foam;
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::READ_IF_PRESENT,
        IOobject::AUTO_WRITE
    );
}


//- Length of the step that ended with the state on disk: OpenFOAM has it as that
//  of the next one, and that of the step before as the last
Foam::scalar lastDeltaT(const Foam::Time& time)
{
    using namespace Foam;
    const IOdictionary state
    (
        IOobject
        (
            "time",
            time.timeName(),
            "uniform",
            time,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    return state.getOrDefault("deltaT", time.deltaT0Value());
}

}


Foam::twoFluids::twoFluids
(
    const volVectorField& U,
    const surfaceScalarField& phiU,
    const dimensionedVector& g
)
:
    mesh_(U.mesh()),
    isChecked_(check(mesh_)),
    mixture_(U, phiU),
    tension_(surfaceTensionModel::New(mixture_, mesh_)),
    weight_(mesh_, g),
    gravity_(mag(g.value())),
    levels_(mesh_, g.value()),
    rho_
    (
        IOobject("rho", U.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimDensity, Zero)
    ),
    mu_
    (
        IOobject("mu", U.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimDynamicViscosity, Zero)
    ),
    massBefore_
    (
        restartField(mesh_, "massBefore"),
        mesh_,
        dimensionedScalar(dimDensity, Zero)
    ),
    rhoPhi_
    (
        restartField(mesh_, "rhoPhi"),
        mesh_,
        dimensionedScalar(dimMass/dimTime, Zero)
    ),
    deltaT_
    (
        "deltaT",
        dimTime,
        massBefore_.typeHeaderOk<volScalarField>(true)
      ? lastDeltaT(U.time())
      : 0
    )
{
    evaluateCoupled(alpha());
    correct();
}


void Foam::twoFluids::correctSurface()
{
    mixture_.alpha2() = 1.0 - alpha();
    static_cast<interfaceProperties&>(mixture_).correct();
}


void Foam::twoFluids::keepTension(const surfaceScalarField& sigmaK)
{
    keptTension_.clear();
    keptTension_ = sigmaK*fvc::snGrad(alpha());
}


void Foam::twoFluids::correct()
{
    mixture_.alpha2() = 1.0 - alpha();
    mixture_.correct();
    rho_ == alpha()*mixture_.rho1() + mixture_.alpha2()*mixture_.rho2();

    // At a wall with a contact angle the density is one iteration behind, as in
    // interFoam
    mu_ ==
        rho_*mixture_.mu()
       /(alpha()*mixture_.rho1() + (1 - alpha())*mixture_.rho2());
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::faceForce() const
{
    tmp<surfaceScalarField> heights(weight_.heights());
    if (levels_.isNeeded())
    {
        heights =
            levels_.heights(alpha(), heights, gravity_, weight_.reference());
    }
    return
        weight_.force(rho_, heights())
      - (
            keptTension_.valid()
          ? tmp<surfaceScalarField>(keptTension_())
          : mixture_.surfaceTensionForce()
        )*mesh_.magSf();
}


Foam::tmp<Foam::volScalarField> Foam::twoFluids::isCarried
(
    const volScalarField& share
) const
{
    // Carried by its own fraction, of which the momentum equation has another
    // one in cells that resolved grains cut or cover
    const volScalarField& fraction =
        mesh_.lookupObject<volScalarField>("fluidFraction");
    return pos(1e-6 - mag(share - max(fraction, exchangeFields::epsMin)));
}


Foam::tmp<Foam::volScalarField> Foam::twoFluids::inertia
(
    const volScalarField& share
) const
{
    if (deltaT_.value() <= 0)
    {
        return share*rho_;
    }
    const volScalarField carried(isCarried(share));
    return
        carried*max(massBefore_, exchangeFields::epsMin*rho_)
      + (1 - carried)*share*rho_;
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::massFlux
(
    const volScalarField& share,
    const surfaceScalarField& phiEps
) const
{
    tmp<surfaceScalarField> tflux
    (
        new surfaceScalarField
        (
            "rhoPhi", phiEps*upwind<scalar>(mesh_, phiEps).interpolate(rho_)
        )
    );
    if (deltaT_.value() > 0)
    {
        const surfaceScalarField carried
        (
            pos(fvc::interpolate(isCarried(share)) - (1 - SMALL))
        );
        // What it moved in its step it moves in this one
        tflux.ref() +=
            carried*(deltaT_/mesh_.time().deltaT()*rhoPhi_ - tflux());
    }
    return tflux;
}


void Foam::twoFluids::setMass
(
    const scalarField& before,
    const surfaceScalarField& flux,
    const surfaceScalarField& alphaFlux
)
{
    massBefore_.primitiveFieldRef() = before;
    massBefore_.correctBoundaryConditions();
    rhoPhi_ =
        mixture_.rho2()*flux + (mixture_.rho1() - mixture_.rho2())*alphaFlux;
    deltaT_ = mesh_.time().deltaT();
}


void Foam::twoFluids::meshChanged()
{
    levels_.meshChanged();
    if (mesh_.topoChanging())
    {
        deltaT_.value() = 0;
    }
}
