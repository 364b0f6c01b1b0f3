/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoFluids.H"

#include "coupledPatches.H"
#include "fvc.H"
#include "missingFields.H"
#include "upwind.H"

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
    levels_(mesh_, g.value(), (mixture_.rho1() - mixture_.rho2()).value()),
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
    mass_(mesh_)
{
    if (mixture_.rho1().value() != mixture_.rho2().value())
    {
        weight_.requireLevelPeriods();
    }
    evaluateCoupled(alpha());
    if (!isThere(mesh_, "phi"))
    {
        // The first pressure has the density at patches that they give, not that
        // of a 'value' in the file, which may be any; the flux that carries, by
        // which they may go, is made later
        const surfaceScalarField phiFluid("phiFluid", phiU);
        alpha().correctBoundaryConditions();
    }
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
        heights = levels_.heights(alpha(), heights, weight_.reference());
    }
    return weight_.force(rho_, heights()) - tensionOfFaces()*mesh_.magSf();
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::tensionOfFaces() const
{
    return
        keptTension_.valid()
      ? tmp<surfaceScalarField>(keptTension_())
      : mixture_.surfaceTensionForce();
}


Foam::tmp<Foam::volScalarField> Foam::twoFluids::inertia
(
    const volScalarField& share
) const
{
    return mass_.inertia(share, rho_);
}


Foam::tmp<Foam::surfaceScalarField> Foam::twoFluids::massFlux
(
    const volScalarField& share,
    const surfaceScalarField& phiEps
) const
{
    return mass_.flux
    (
        share,
        tmp<surfaceScalarField>
        (
            new surfaceScalarField
            (
                "rhoPhi", phiEps*upwind<scalar>(mesh_, phiEps).interpolate(rho_)
            )
        )
    );
}


void Foam::twoFluids::setMass
(
    const scalarField& before,
    const surfaceScalarField& flux,
    const surfaceScalarField& alphaFlux
)
{
    mass_.set
    (
        before,
        mixture_.rho2()*flux + (mixture_.rho1() - mixture_.rho2())*alphaFlux
    );
}


void Foam::twoFluids::meshChanged()
{
    levels_.meshChanged();
    if (mesh_.topoChanging())
    {
        mass_.forget();
    }
}
