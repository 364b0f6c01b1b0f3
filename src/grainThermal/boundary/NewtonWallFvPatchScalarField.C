/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "NewtonWallFvPatchScalarField.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "fvPatchFieldMapper.H"
#include "volFields.H"

namespace Foam
{
    makePatchTypeField(fvPatchScalarField, NewtonWallFvPatchScalarField);
}

namespace
{

Foam::scalarField fieldOf
(
    const Foam::dictionary& dict,
    const Foam::word& keyword,
    const Foam::label size,
    const Foam::scalar low
)
{
    using namespace Foam;
    const string allowed("a field of values >= " + name(low));
    if (!dict.found(keyword))
    {
        dictionaryInput::missing(dict, keyword, allowed);
    }
    scalarField result;
    const auto set = [&] { result = scalarField(keyword, dict, size); };
    if
    (
        dictionaryInput::errorOf(set).size()
     || (result.size() && !(min(result) >= low))
    )
    {
        dictionaryInput::badValue
        (
            dict, keyword, dictionaryInput::written(dict, keyword), allowed
        );
    }
    return result;
}

}


Foam::NewtonWallFvPatchScalarField::NewtonWallFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(p, iF),
    ofCell_(false),
    h_(p.size(), Zero),
    Ta_(p.size(), Zero)
{
    refValue() = 0;
    refGrad() = 0;
    valueFraction() = 0;
}


Foam::NewtonWallFvPatchScalarField::NewtonWallFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    mixedFvPatchScalarField(p, iF),
    ofCell_
    (
        dictionaryInput::getWordOrDefault
        (
            dict, "of", "surface", {"cell", "surface"}
        ) == "cell"
    ),
    h_(fieldOf(dict, "h", p.size(), 0)),
    Ta_(fieldOf(dict, "Ta", p.size(), SMALL))
{
    refValue() = Ta_;
    refGrad() = 0;
    valueFraction() = 0;
    fvPatchScalarField::operator=
    (
        dict.found("value") ? scalarField("value", dict, p.size()) : Ta_
    );
}


Foam::NewtonWallFvPatchScalarField::NewtonWallFvPatchScalarField
(
    const NewtonWallFvPatchScalarField& other,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    mixedFvPatchScalarField(other, p, iF, mapper),
    ofCell_(other.ofCell_),
    h_(other.h_, mapper),
    Ta_(other.Ta_, mapper)
{}


Foam::NewtonWallFvPatchScalarField::NewtonWallFvPatchScalarField
(
    const NewtonWallFvPatchScalarField& other,
    const DimensionedField<scalar, volMesh>& iF
)
:
    mixedFvPatchScalarField(other, iF),
    ofCell_(other.ofCell_),
    h_(other.h_),
    Ta_(other.Ta_)
{}


Foam::scalarField Foam::NewtonWallFvPatchScalarField::ratio() const
{
    const word name("openConductivity");
    if (!db().foundObject<volScalarField>(name))
    {
        return scalarField(size(), Zero);
    }
    const scalarField& k =
        patch().lookupPatchField<volScalarField, scalar>(name);
    return h_/(k*patch().deltaCoeffs());
}


void Foam::NewtonWallFvPatchScalarField::autoMap(const fvPatchFieldMapper& m)
{
    mixedFvPatchScalarField::autoMap(m);
    h_.autoMap(m);
    Ta_.autoMap(m);
}


void Foam::NewtonWallFvPatchScalarField::rmap
(
    const fvPatchScalarField& other,
    const labelList& addressing
)
{
    mixedFvPatchScalarField::rmap(other, addressing);
    const NewtonWallFvPatchScalarField& wall =
        refCast<const NewtonWallFvPatchScalarField>(other);
    h_.rmap(wall.h_, addressing);
    Ta_.rmap(wall.Ta_, addressing);
}


void Foam::NewtonWallFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    const scalarField r(ratio());
    refValue() = Ta_;
    valueFraction() =
        ofCell_ ? scalarField(min(r, scalar(1))) : scalarField(r/(1 + r));
    mixedFvPatchScalarField::updateCoeffs();
}


Foam::tmp<Foam::scalarField> Foam::NewtonWallFvPatchScalarField::snGrad() const
{
    return
        ofCell_
      ? ratio()*patch().deltaCoeffs()*(Ta_ - patchInternalField())
      : mixedFvPatchScalarField::snGrad();
}


Foam::tmp<Foam::scalarField>
Foam::NewtonWallFvPatchScalarField::gradientInternalCoeffs() const
{
    return
        ofCell_
      ? -ratio()*patch().deltaCoeffs()
      : mixedFvPatchScalarField::gradientInternalCoeffs();
}


Foam::tmp<Foam::scalarField>
Foam::NewtonWallFvPatchScalarField::gradientBoundaryCoeffs() const
{
    return
        ofCell_
      ? ratio()*patch().deltaCoeffs()*Ta_
      : mixedFvPatchScalarField::gradientBoundaryCoeffs();
}


void Foam::NewtonWallFvPatchScalarField::write(Ostream& os) const
{
    fvPatchScalarField::write(os);
    os.writeEntry("of", ofCell_ ? "cell" : "surface");
    h_.writeEntry("h", os);
    Ta_.writeEntry("Ta", os);
    writeEntry("value", os);
}
