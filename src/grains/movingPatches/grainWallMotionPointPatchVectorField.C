/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainWallMotionPointPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "initialPoints.H"
#include "pointFields.H"
#include "startOfStep.H"

namespace Foam
{
    makePointPatchTypeField
    (
        pointPatchVectorField,
        grainWallMotionPointPatchVectorField
    );
}


Foam::grainWallMotionPointPatchVectorField::
grainWallMotionPointPatchVectorField
(
    const pointPatch& p,
    const DimensionedField<vector, pointMesh>& iF
)
:
    fixedValuePointPatchField<vector>(p, iF)
{}


Foam::grainWallMotionPointPatchVectorField::
grainWallMotionPointPatchVectorField
(
    const pointPatch& p,
    const DimensionedField<vector, pointMesh>& iF,
    const dictionary& dict
)
:
    fixedValuePointPatchField<vector>(p, iF, dict)
{
    if (iF.dimensions() != dimLength)
    {
        FatalIOErrorInFunction(dict)
            << "Keyword 'type' has the value 'grainWallMotion' on patch '"
            << p.name() << "' of " << iF.name() << " of dimensions "
            << iF.dimensions() << nl
            << "    allowed: in pointDisplacement " << dimLength
            << exit(FatalIOError);
    }
}


Foam::grainWallMotionPointPatchVectorField::
grainWallMotionPointPatchVectorField
(
    const grainWallMotionPointPatchVectorField& other,
    const pointPatch& p,
    const DimensionedField<vector, pointMesh>& iF,
    const pointPatchFieldMapper& mapper
)
:
    fixedValuePointPatchField<vector>(other, p, iF, mapper)
{}


Foam::grainWallMotionPointPatchVectorField::
grainWallMotionPointPatchVectorField
(
    const grainWallMotionPointPatchVectorField& other,
    const DimensionedField<vector, pointMesh>& iF
)
:
    fixedValuePointPatchField<vector>(other, iF)
{}


void Foam::grainWallMotionPointPatchVectorField::prepare()
{
    const fvMesh& mesh = refCast<const fvMesh>(internalField().mesh()());
    const polyPatch& patch = mesh.boundaryMesh()[this->patch().index()];

    // All ranks at once
    if (!displacement_)
    {
        displacement_ = wallDisplacement::New(mesh, patch);
    }
    initial_ = pointField(initialPoints(mesh)(), patch.meshPoints());
}


void Foam::grainWallMotionPointPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    if (!displacement_ || initial_.size() != size())
    {
        prepare();
    }
    const Time& runTime = internalField().mesh().time();
    Field<vector>::operator=
    (
        displacement_->at
        (
            initial_, startOfStep(runTime) + runTime.deltaTValue()
        )
    );
    fixedValuePointPatchField<vector>::updateCoeffs();
}


void Foam::grainWallMotionPointPatchVectorField::write(Ostream& os) const
{
    pointPatchField<vector>::write(os);
    writeEntry("value", os);
}
