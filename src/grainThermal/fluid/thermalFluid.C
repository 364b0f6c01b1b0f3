/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "thermalFluid.H"

#include "dictionaryInput.H"
#include "functionEntries.H"
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


//- Null for a number
autoPtr<enthalpy> varyingCapacity(const dictionary& dict)
{
    return
        dictionaryInput::isFunction(dict, "Cp")
      ? autoPtr<enthalpy>(new enthalpy(dict))
      : autoPtr<enthalpy>();
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
    enthalpy_(varyingCapacity(properties())),
    capacity_
    (
        dictionaryInput::getPositive(properties(), "rho", dimDensity)
       *(
            enthalpy_
          ? enthalpy_->capacity(enthalpy::T0)
          : dictionaryInput::getPositive(properties(), "Cp", dimHeatCapacity)
        )
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
        IOobject("kappaOfFluid", U.time().timeName(), U.mesh()),
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
    volScalarField C
    (
        IOobject("C", T_.time().timeName(), T_.mesh()),
        T_.mesh(),
        dimensionedScalar("C", kappa_.dimensions()/dimViscosity, capacity_)
    );
    if (enthalpy_)
    {
        const auto set = [&](const scalarField& T, scalarField& C)
        {
            forAll(C, i)
            {
                C[i] *= enthalpy_->slope(T[i]);
            }
        };
        set(T_.primitiveField(), C.primitiveFieldRef());
        forAll(T_.boundaryField(), patchi)
        {
            set(T_.boundaryField()[patchi], C.boundaryFieldRef()[patchi]);
        }
    }
    return kappa_ + C/Prt_*(*nut());
}


Foam::scalar Foam::thermalFluid::capacity(const label celli) const
{
    return enthalpy_ ? capacity_*enthalpy_->slope(T_[celli]) : capacity_;
}


void Foam::thermalFluid::checkRange(const scalar least, const scalar most) const
{
    const label steps = 1 + label(min(most - least, scalar(10000)));
    for (label i = 0; i <= steps; ++i)
    {
        const scalar T = least + i*(most - least)/steps;
        kappaOfT_.at(T);
        if (muOfT_)
        {
            muOfT_->at(T);
        }
        if (enthalpy_)
        {
            enthalpy_->capacity(T);
        }
    }
}
