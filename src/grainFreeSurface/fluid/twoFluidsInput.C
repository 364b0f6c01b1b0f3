/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoFluids.H"

#include "dictionaryInput.H"
#include "surfaceTensionModel.H"
#include "viscosityModel.H"

namespace
{

using namespace Foam;

void checkPhase(const dictionary& properties, const word& name)
{
    const dictionary& phase = dictionaryInput::subDict(properties, name);
    const word model
    (
        dictionaryInput::getWord
        (
            phase, "transportModel",
            viscosityModel::dictionaryConstructorTablePtr_->sortedToc()
        )
    );
    wordList allowed({"transportModel", "rho", model + "Coeffs"});
    dictionaryInput::getPositive(phase, "rho", dimDensity);
    if (model == "Newtonian")
    {
        dictionaryInput::getPositive
        (
            phase.optionalSubDict(model + "Coeffs"), "nu", dimViscosity
        );
        allowed.append("nu");
    }
    dictionaryInput::checkKeywords(phase, allowed);
}


void checkContactAngles(const volScalarField& alpha)
{
    for (const fvPatchScalarField& patch : alpha.boundaryField())
    {
        OStringStream text;
        patch.write(text);
        const dictionary dict(IStringStream(text.str())());
        if (!dict.found("theta0"))
        {
            continue;
        }
        const scalar theta = dict.get<scalar>("theta0");
        if (theta < 0 || theta > 180)
        {
            FatalErrorInFunction
                << "Field " << alpha.objectPath() << ", boundaryField "
                << patch.patch().name() << ": keyword 'theta0' has the value "
                << theta << nl << "    allowed: an angle in degrees, 0 to 180"
                << exit(FatalError);
        }
    }
}


void checkFraction(const fvMesh& mesh, const word& name)
{
    // Differences of what setFields and mapFields write, and of ASCII
    constexpr scalar roundOff = 1e-6;

    const volScalarField alpha
    (
        IOobject
        (
            name, mesh.time().timeName(), mesh, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        ),
        mesh
    );
    dictionaryInput::checkDimensions(alpha, alpha.dimensions(), dimless);
    const scalar low = gMin(alpha.primitiveField());
    const scalar high = gMax(alpha.primitiveField());
    if (low < -roundOff || high > 1 + roundOff)
    {
        FatalErrorInFunction
            << "Field " << alpha.objectPath() << ", internalField: values from "
            << low << " to " << high << nl
            << "    allowed: a volume fraction, 0 to 1" << exit(FatalError);
    }
    for (const fvPatchScalarField& patch : alpha.boundaryField())
    {
        if
        (
            patch.fixesValue() && patch.size()
         && (min(patch) < -roundOff || max(patch) > 1 + roundOff)
        )
        {
            FatalErrorInFunction
                << "Field " << alpha.objectPath() << ", boundaryField "
                << patch.patch().name() << ": values from " << min(patch)
                << " to " << max(patch) << nl
                << "    allowed: a volume fraction, 0 to 1" << exit(FatalError);
        }
    }
    checkContactAngles(alpha);
}

}


bool Foam::twoFluids::check(const fvMesh& mesh)
{
    const IOdictionary properties
    (
        IOobject
        (
            "transportProperties", mesh.time().constant(), mesh,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    const string twoNames("two names of phases, as (water air)");
    const wordList phases
    (
        dictionaryInput::getAs<wordList>(properties, "phases", twoNames)
    );
    if (phases.size() != 2 || phases[0] == phases[1])
    {
        dictionaryInput::badValue
        (
            properties, "phases",
            dictionaryInput::written(properties, "phases"), twoNames
        );
    }
    for (const word& phase : phases)
    {
        checkPhase(properties, phase);
    }
    if (properties.isDict("sigma"))
    {
        // Others of OpenFOAM's ask for a field T
        const dictionary& model = properties.subDict("sigma");
        dictionaryInput::getWord(model, "type", {"constant"});
        dictionaryInput::getScalar
        (
            model, "sigma", dimensionSet(1, 0, -2, 0, 0), 0
        );
    }
    else
    {
        dictionaryInput::getScalar
        (
            properties, "sigma", dimensionSet(1, 0, -2, 0, 0), 0
        );
    }
    dictionaryInput::checkKeywords
    (
        properties,
        {"FoamFile", "phases", phases[0], phases[1], "sigma", "scalars"}
    );
    checkFraction(mesh, IOobject::groupName("alpha", phases[0]));
    return true;
}
