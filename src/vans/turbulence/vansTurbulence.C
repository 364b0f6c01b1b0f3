/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansTurbulence.H"

#include "dictionaryInput.H"
#include "turbulenceModel.H"

bool Foam::vansTurbulence::isSelected(const fvMesh& mesh)
{
    const IOdictionary dict
    (
        IOobject
        (
            turbulenceModel::propertiesName,
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    if (dict.empty())
    {
        return false;
    }
    const word type
    (
        dictionaryInput::getWord(dict, "simulationType", {"laminar", "RAS", "LES"})
    );
    if (type == "laminar" && dict.found("laminar"))
    {
        // The keyword of OpenFOAM v1912, and that of later versions
        const dictionary& laminar = dictionaryInput::subDict(dict, "laminar");
        for (const word keyword : {"laminarModel", "model"})
        {
            dictionaryInput::getWordOrDefault
            (
                laminar, keyword, "Stokes", {"Stokes"}
            );
        }
    }
    if (type != "laminar")
    {
        dictionaryInput::subDict(dict, type);
    }
    return type != "laminar";
}


Foam::vansTurbulence::vansTurbulence
(
    const vansFields& fields,
    const transportFlux& flux,
    singleFluid& fluid
)
:
    fluid_(fluid),
    flux_("alphaPhi", flux.flux()),
    model_
    (
        PhaseIncompressibleTurbulenceModel<singlePhaseTransportModel>::New
        (
            flux.fraction(), fields.U, flux_, fields.phiU, fluid.transport()
        )
    ),
    registered_(*model_, fields.phiU, fluid.transport())
{
    model_->validate();
    setViscosity();
}


void Foam::vansTurbulence::setViscosity()
{
    fluid_.setTurbulence(model_->nut());
}


void Foam::vansTurbulence::correct(const transportFlux& flux)
{
    flux_ = flux.flux();
    registered_.correct();
    setViscosity();
}
