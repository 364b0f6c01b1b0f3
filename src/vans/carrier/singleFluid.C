/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "singleFluid.H"

#include "dictionaryInput.H"
#include "fluidInput.H"
#include "fvc.H"
#include "HeleShaw.H"
#include "transportFlux.H"
#include "viscosityModel.H"

namespace
{


using namespace Foam;

const word Newtonian("Newtonian");


//- Plates shear the fluid across the mesh, which models of viscosity do not see
void checkPlates(const dictionary& dict, const fvMesh& mesh)
{
    const word model(dict.getOrDefault<word>("transportModel", Newtonian));
    if (model != Newtonian)
    {
        dictionaryInput::badValue
        (
            dict, "transportModel", model, "Newtonian, as there is HeleShaw"
        );
    }
    if (mesh.nSolutionD() == 3)
    {
        dictionaryInput::badValue
        (
            dict, "HeleShaw", "{ ... }",
            "nothing, or a mesh that is one cell thick, between patches of type empty"
        );
    }
}

}


Foam::singleFluid::singleFluid
(
    const volVectorField& U,
    const surfaceScalarField& phiU,
    const wordList& moreEntries,
    const wordList& moreEntriesOfPlates
)
:
    properties_("transportProperties", U.mesh()),
    rho_
    (
        IOobject("rho", U.time().timeName(), U.mesh()),
        U.mesh(),
        dimensionedScalar
        (
            "rho",
            dimDensity,
            dictionaryInput::getPositive(properties_, "rho", dimDensity)
        )
    ),
    mu_
    (
        IOobject("mu", U.time().timeName(), U.mesh()),
        U.mesh(),
        dimensionedScalar(dimDynamicViscosity, Zero)
    ),
    mass_(U.mesh()),
    Sct_
    (
        dictionaryInput::getPositiveOrDefault(properties_, "Sct", dimless, 0.85)
    ),
    plates_
    (
        "plates",
        dimless/dimArea,
        HeleShawPlates(properties_, moreEntriesOfPlates)
    )
{
    if (properties_.found("transportModel"))
    {
        dictionaryInput::getWord
        (
            properties_, "transportModel",
            viscosityModel::dictionaryConstructorTablePtr_->sortedToc()
        );
    }
    if (plates_.value() > 0)
    {
        checkPlates(properties_, U.mesh());
    }
    checkTransportProperties(properties_, moreEntries);
    requireDivScheme(U.mesh(), "div(phiEps,U)");
    if (properties_.found("transportModel"))
    {
        model_.reset(new singlePhaseTransportModel(U, phiU));
    }
    if (!properties_.found("mu"))
    {
        setMu();
    }
}


Foam::dimensionedScalar Foam::singleFluid::nu() const
{
    return dimensionedScalar
    (
        "nu",
        dimViscosity,
        dictionaryInput::getPositive
        (
            properties_.optionalSubDict("NewtonianCoeffs"), "nu", dimViscosity
        )
    );
}


Foam::tmp<Foam::volScalarField> Foam::singleFluid::muWithoutModel() const
{
    return rho_*nu();
}


void Foam::singleFluid::setMu()
{
    if (model_)
    {
        mu_ == rho_*model_->nu();
    }
    else
    {
        mu_ == muWithoutModel();
    }
    if (nut_)
    {
        *muStress_ == mu_ + rho_**nut_;
    }
}


void Foam::singleFluid::correct()
{
    if (model_)
    {
        model_->correct();
        setMu();
    }
    else if (properties_.found("mu"))
    {
        setMu();
    }
}


Foam::tmp<Foam::volScalarField> Foam::singleFluid::wallDrag() const
{
    return
        plates_.value() > 0
      ? plates_*mu_
      : tmp<volScalarField>();
}


Foam::tmp<Foam::volScalarField> Foam::singleFluid::inertia
(
    const volScalarField& share
) const
{
    return mass_.inertia(share, rho_);
}


Foam::tmp<Foam::surfaceScalarField> Foam::singleFluid::massFlux
(
    const volScalarField& share,
    const surfaceScalarField& phiEps
) const
{
    return mass_.flux(share, carrier::massFlux(share, phiEps));
}


void Foam::singleFluid::setMass(const transportFlux& flux)
{
    mass_.set
    (
        rho_.primitiveField()
       *(
            flux.oldVolume()/rho_.mesh().V().field()
          + rho_.time().deltaTValue()*flux.source()
        ),
        fvc::interpolate(rho_)
       *(mass_.keepsCorrection() ? flux.added() : flux.flux())
    );
}


Foam::singlePhaseTransportModel& Foam::singleFluid::transport()
{
    if (!model_)
    {
        FatalIOErrorInFunction(properties_)
            << "Keyword 'transportModel' is missing: turbulence models need it"
            << nl << "    allowed: transportModel Newtonian;"
            << exit(FatalIOError);
    }
    return *model_;
}


void Foam::singleFluid::setTurbulence(const volScalarField& nut)
{
    nut_.reset(new volScalarField("nutOfStress", nut));
    if (!muStress_)
    {
        muStress_.reset(new volScalarField("muStress", mu_));
    }
    setMu();
}


void Foam::singleFluid::addTurbulence
(
    surfaceScalarField& conductivity,
    const volScalarField& open
) const
{
    if (nut_)
    {
        conductivity += fvc::interpolate(open*(*nut_/Sct_));
    }
}
