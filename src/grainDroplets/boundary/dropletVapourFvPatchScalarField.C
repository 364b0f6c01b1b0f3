/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletVapourFvPatchScalarField.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "fvPatchFieldMapper.H"
#include "surfaceFields.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField(fvPatchScalarField, dropletVapourFvPatchScalarField);
}


Foam::dropletVapourFvPatchScalarField::dropletVapourFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(p, iF),
    D_(0),
    phiName_("phiFluid")
{
    refValue() = 1;
    refGrad() = 0;
    valueFraction() = 0;
}


Foam::dropletVapourFvPatchScalarField::dropletVapourFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    mixedFvPatchScalarField(p, iF),
    D_(dictionaryInput::getScalar(dict, "D", dimViscosity, 0)),
    phiName_(dict.lookupOrDefault<word>("phi", "phiFluid"))
{
    refValue() = 1;
    refGrad() = 0;
    valueFraction() = 0;
    fvPatchScalarField::operator=
    (
        dict.found("value")
      ? scalarField("value", dict, p.size())
      : scalarField(p.size(), 1)
    );
}


Foam::dropletVapourFvPatchScalarField::dropletVapourFvPatchScalarField
(
    const dropletVapourFvPatchScalarField& other,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    mixedFvPatchScalarField(other, p, iF, mapper),
    D_(other.D_),
    phiName_(other.phiName_)
{}


Foam::dropletVapourFvPatchScalarField::dropletVapourFvPatchScalarField
(
    const dropletVapourFvPatchScalarField& other,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(other, iF),
    D_(other.D_),
    phiName_(other.phiName_)
{}


void Foam::dropletVapourFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    if (db().foundObject<surfaceScalarField>(phiName_))
    {
        const scalarField in
        (
            max
            (
               -patch().lookupPatchField<surfaceScalarField, scalar>(phiName_)
               /patch().magSf(),
                scalar(0)
            )
        );
        valueFraction() = in/max(in + D_*patch().deltaCoeffs(), VSMALL);
    }
    mixedFvPatchScalarField::updateCoeffs();
}


void Foam::dropletVapourFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    os.writeEntry("D", D_);
    os.writeEntry("phi", phiName_);
    writeEntry("value", os);
}
