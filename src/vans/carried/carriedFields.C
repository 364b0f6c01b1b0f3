/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carriedFields.H"

#include "dictionaryInput.H"
#include "resolvedTerm.H"
#include "surfaceInterpolate.H"
#include "vansTurbulence.H"

namespace
{

using namespace Foam;

// Closed volume of a cell where only momentum asks for it: what is lost of it is this
// much in a step at most, where steps at 1e-12 took a sixth of a bed's time
constexpr scalar ofMassAlone = 1e-8;


//- Fatal for the name of a field that the solver has, or will have
void checkName(const dictionary& dict, const word& name, const fvMesh& mesh)
{
    static const wordList taken
    {
        "U", "p", "p_rgh", "eps", "phi", "phiU", "phiMomentum", "phiOpen", "phiShare",
        "gradP_rgh", "kappa", "fluidShare", "transportPotential"
    };
    if (taken.found(name) || mesh.thisDb().found(name))
    {
        dictionaryInput::badValue
        (
            dict, name, "the name of a field of the solver",
            "names of scalars other than " + dictionaryInput::listed(taken)
        );
    }
}

}


void Foam::carriedFields::readScalars
(
    const fvMesh& mesh,
    const dictionary& transportProperties
)
{
    if (!transportProperties.found("scalars"))
    {
        return;
    }
    const dictionary& dict =
        dictionaryInput::subDict(transportProperties, "scalars");
    for (const word& name : dict.toc())
    {
        const dictionary& entries = dictionaryInput::subDict(dict, name);
        dictionaryInput::checkKeywords(entries, {"D"});
        checkName(dict, name, mesh);
        D_.append
        (
            dictionaryInput::getScalarOrDefault
            (
                entries, "D", dimViscosity, 0, 0
            )
        );
        scalars_.append(new fluidScalar(mesh, name));
    }
}


Foam::carriedFields::carriedFields
(
    const vansFields& fields,
    const volScalarField& eps,
    const diffusionAmongGrains& diffusion,
    singleFluid& fluid,
    const bool isMore
)
:
    diffusion_(diffusion),
    flux_(eps, fvc::interpolate(eps)*fields.phiU, fields.p_rgh),
    fluid_(&fluid),
    hasMass_(true),
    isMore_(isMore),
    hasCarried_(false),
    makesRoom_(false)
{
    readScalars(eps.mesh(), fluid.properties());
    if (vansTurbulence::isSelected(eps.mesh()))
    {
        turbulence_.reset(new vansTurbulence(fields, flux_, fluid));
    }
}


Foam::carriedFields::carriedFields
(
    const vansFields& fields,
    const volScalarField& eps,
    const diffusionAmongGrains& diffusion,
    const dictionary& transportProperties
)
:
    diffusion_(diffusion),
    flux_(eps, fvc::interpolate(eps)*fields.phiU, fields.p_rgh, true),
    fluid_(nullptr),
    hasMass_(false),
    isMore_(true),
    hasCarried_(false),
    makesRoom_(false)
{
    readScalars(eps.mesh(), transportProperties);
}


Foam::carriedFields::~carriedFields() = default;


void Foam::carriedFields::surround(const resolvedTerm& resolved)
{
    hasMass_ = hasMass_ && !resolved.leavesParts();
}


bool Foam::carriedFields::isActive() const
{
    return isMore_ || turbulence_ || scalars_.size();
}


void Foam::carriedFields::startStep()
{
    flux_.startStep();
    makesRoom_ = false;
}


void Foam::carriedFields::makeRoom()
{
    makesRoom_ = true;
    if (hasMass_)
    {
        fluid_->forgetMass();
    }
}


void Foam::carriedFields::beforeMeshChange()
{
    for (fluidScalar& one : scalars_)
    {
        one.beforeMeshChange(flux_);
    }
}


void Foam::carriedFields::meshChanged()
{
    for (fluidScalar& one : scalars_)
    {
        one.meshChanged(flux_);
    }
    flux_.meshChanged();
    if (hasMass_ && flux_.fraction().mesh().topoChanging())
    {
        fluid_->forgetMass();
    }
}


void Foam::carriedFields::carryScalars()
{
    if (scalars_.empty())
    {
        return;
    }
    const surfaceScalarField part(diffusion_.onFaces(flux_.fraction()));
    forAll(scalars_, i)
    {
        surfaceScalarField conductivity
        (
            dimensionedScalar("D", dimViscosity, D_[i])*part
        );
        if (turbulence_)
        {
            fluid_->addTurbulence(conductivity, flux_.fraction());
        }
        scalars_[i].carry(flux_, conductivity);
    }
}


void Foam::carriedFields::carry
(
    const surfaceScalarField& share,
    const scalarField& filled,
    const scalarField& weight
)
{
    const fvMesh& mesh = share.mesh();
    flux_.set
    (
        share,
        filled.size()
      ? scalarField(filled/mesh.time().deltaTValue())
      : scalarField(mesh.nCells(), Zero),
        weight,
        isActive() ? 1e-12 : ofMassAlone
    );
    if (turbulence_)
    {
        turbulence_->correct(flux_);
    }
    carryScalars();
    if (hasMass_ && makesRoom_)
    {
        fluid_->forgetMass();
    }
    else if (hasMass_)
    {
        fluid_->setMass(flux_);
    }
    hasCarried_ = true;
}


void Foam::carriedFields::skip()
{
    flux_.skip();
    if (hasMass_)
    {
        fluid_->forgetMass();
    }
    hasCarried_ = false;
}


Foam::scalar Foam::carriedFields::unaccounted() const
{
    scalar worst = 0;
    for (const fluidScalar& one : scalars_)
    {
        worst = max
        (
            worst,
            mag(one.unaccounted())/max(one.magnitude(flux_), VSMALL)
        );
    }
    return worst;
}
