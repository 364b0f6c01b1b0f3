/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "thermalFluid.H"

#include "dictionaryInput.H"
#include "heatDimensions.H"

namespace
{

using namespace Foam;

dimensionedScalar expansion(const dictionary& dict)
{
    return dimensionedScalar
    (
        "beta",
        dimless/dimTemperature,
        dictionaryInput::getScalarOrDefault
        (
            dict, "beta", dimless/dimTemperature, 0, -GREAT
        )
    );
}


dimensionedScalar reference(const dictionary& dict)
{
    return dimensionedScalar
    (
        "TRef",
        dimTemperature,
        expansion(dict).value() == 0 && !dict.found("TRef")
      ? 0
      : dictionaryInput::getPositive(dict, "TRef", dimTemperature)
    );
}

}


Foam::thermalFluid::thermalFluid
(
    const volVectorField& U,
    const surfaceScalarField& phiU,
    const volScalarField& T,
    const dimensionedVector& g
)
:
    singleFluid
    (
        U, phiU, keywords(), plateHeat::keywords()
    ),
    T_(T),
    capacity_
    (
        dictionaryInput::getPositive(properties(), "rho", dimDensity)
       *dictionaryInput::getPositive(properties(), "Cp", dimHeatCapacity)
    ),
    kappaOfT_(properties(), "kappa", dimConductivity),
    beta_(expansion(properties())),
    TRef_(reference(properties())),
    Prt_
    (
        dictionaryInput::getPositiveOrDefault(properties(), "Prt", dimless, 0.85)
    ),
    plates_(properties()),
    weight_(U.mesh(), g),
    rhoWeight_("rhoWeight", rho()),
    kappa_
    (
        IOobject("kappa", U.time().timeName(), U.mesh()),
        U.mesh(),
        dimensionedScalar(dimConductivity, Zero)
    )
{
    if (properties().found("mu"))
    {
        muOfT_.reset
        (
            new functionOfTemperature(properties(), "mu", dimDynamicViscosity)
        );
    }
    correct();
}


Foam::wordList Foam::thermalFluid::keywords()
{
    return wordList({"Cp", "kappa", "mu", "beta", "TRef", "Prt", "vapour"});
}


void Foam::thermalFluid::correct()
{
    singleFluid::correct();
    rhoWeight_ == rho()*(1 - beta_*(T_ - TRef_));
    kappaOfT_.set(kappa_, T_);
}


Foam::tmp<Foam::volScalarField> Foam::thermalFluid::muWithoutModel() const
{
    if (!muOfT_)
    {
        return singleFluid::muWithoutModel();
    }
    tmp<volScalarField> tmu
    (
        new volScalarField
        (
            IOobject("muOfT", T_.time().timeName(), T_.mesh()),
            T_.mesh(),
            dimensionedScalar(dimDynamicViscosity, Zero)
        )
    );
    muOfT_->set(tmu.ref(), T_);
    return tmu;
}


Foam::tmp<Foam::surfaceScalarField> Foam::thermalFluid::faceForce() const
{
    return
        isBuoyant()
      ? weight_.force(rhoWeight_)
      : tmp<surfaceScalarField>();
}


Foam::tmp<Foam::volScalarField> Foam::thermalFluid::kappaEff() const
{
    if (!nut())
    {
        return tmp<volScalarField>(kappa_);
    }
    return
        kappa_
      + dimensionedScalar
        (
            "C", kappa_.dimensions()/dimViscosity, capacity_/Prt_
        )*(*nut());
}
