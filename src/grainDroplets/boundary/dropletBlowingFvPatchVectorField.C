/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletBlowingFvPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "fvPatchFieldMapper.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField(fvPatchVectorField, dropletBlowingFvPatchVectorField);
}


Foam::dropletBlowingFvPatchVectorField::dropletBlowingFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    latentHeat_(1),
    vapourDensity_(1),
    isLocal_(true),
    velocity_(Zero)
{}


Foam::dropletBlowingFvPatchVectorField::dropletBlowingFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    latentHeat_
    (
        dictionaryInput::getPositive
        (
            dict, "latentHeat", dimensionSet(0, 2, -2, 0, 0)
        )
    ),
    vapourDensity_(dictionaryInput::getPositive(dict, "vapourDensity", dimDensity)),
    isLocal_
    (
        dictionaryInput::getWordOrDefault
        (
            dict, "blowing", "local", {"local", "uniform"}
        ) == "local"
    ),
    velocity_(dict.lookupOrDefault<vector>("velocity", Zero))
{
    fvPatchVectorField::operator=
    (
        dict.found("value")
      ? vectorField("value", dict, p.size())
      : vectorField(p.size(), velocity_)
    );
}


Foam::dropletBlowingFvPatchVectorField::dropletBlowingFvPatchVectorField
(
    const dropletBlowingFvPatchVectorField& other,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(other, p, iF, mapper),
    latentHeat_(other.latentHeat_),
    vapourDensity_(other.vapourDensity_),
    isLocal_(other.isLocal_),
    velocity_(other.velocity_)
{}


Foam::dropletBlowingFvPatchVectorField::dropletBlowingFvPatchVectorField
(
    const dropletBlowingFvPatchVectorField& other,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(other, iF),
    latentHeat_(other.latentHeat_),
    vapourDensity_(other.vapourDensity_),
    isLocal_(other.isLocal_),
    velocity_(other.velocity_)
{}


Foam::scalarField Foam::dropletBlowingFvPatchVectorField::heatFlux() const
{
    const word conductivity("openConductivity");
    if
    (
        !db().foundObject<volScalarField>("T")
     || !db().foundObject<volScalarField>(conductivity)
    )
    {
        return scalarField(size(), Zero);
    }
    return
       -patch().lookupPatchField<volScalarField, scalar>(conductivity)
       *patch().lookupPatchField<volScalarField, scalar>("T").snGrad();
}


Foam::scalarField
Foam::dropletBlowingFvPatchVectorField::blowingSpeed() const
{
    // A droplet at its boiling temperature takes no vapour back
    const scalar perFlux = 1/(latentHeat_*vapourDensity_);
    const scalarField q(heatFlux());
    if (isLocal_)
    {
        return perFlux*max(q, scalar(0));
    }
    const scalarField& S = patch().magSf();
    const scalar mean = gSum(S*q)/max(gSum(S), VSMALL);
    return scalarField(size(), perFlux*max(mean, scalar(0)));
}


void Foam::dropletBlowingFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    fvPatchVectorField::operator==(velocity_ - blowingSpeed()*patch().nf());
    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::dropletBlowingFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    os.writeEntry("latentHeat", latentHeat_);
    os.writeEntry("vapourDensity", vapourDensity_);
    os.writeEntry("blowing", word(isLocal_ ? "local" : "uniform"));
    os.writeEntry("velocity", velocity_);
    writeEntry("value", os);
}
