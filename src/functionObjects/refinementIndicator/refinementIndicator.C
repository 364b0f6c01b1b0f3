/*---------------------------------------------------------------------------*\
   SPDX-FileCopyrightText: 2026 The grainFoam authors
   SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refinementIndicator.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "functionKeywords.H"
#include "fvc.H"
#include "linear.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(refinementIndicator, 0);
    addToRunTimeSelectionTable(functionObject, refinementIndicator, dictionary);
}
}

namespace
{

const Foam::word none("none");

// As the Courant number of the surface
constexpr Foam::scalar lowerAlpha = 0.01;

// Of values of alpha
constexpr Foam::scalar roundOff = 1e-6;

}


Foam::functionObjects::refinementIndicator::refinementIndicator
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


bool Foam::functionObjects::refinementIndicator::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {"alpha", "upperAlpha", "fluidFraction", "margin", "result"});

    const string aField("the name of a field of the solver, as alpha.water");
    alphaName_ =
        dict.found("alpha")
      ? dictionaryInput::getAs<word>(dict, "alpha", aField)
      : none;
    if
    (
        !postProcess && alphaName_ != none
     && !mesh_.foundObject<volScalarField>(alphaName_)
    )
    {
        dictionaryInput::badValue(dict, "alpha", alphaName_, aField);
    }

    const string aName("a name that no field has");
    result_.clear();
    resultName_ =
        dict.found("result")
      ? dictionaryInput::getAs<word>(dict, "result", aName)
      : word("refinement");
    if (mesh_.foundObject<regIOobject>(resultName_))
    {
        dictionaryInput::badValue(dict, "result", resultName_, aName);
    }

    upperAlpha_ = dictionaryInput::getScalarOrDefault
    (
        dict, "upperAlpha", dimless, 1 - lowerAlpha, lowerAlpha, 1
    );
    fluidFraction_ = dictionaryInput::getScalarOrDefault
    (
        dict, "fluidFraction", dimless, 0.999, 0, 1
    );
    margin_ = dictionaryInput::getLabelOrDefault(dict, "margin", 0, 0);
    result_.reset
    (
        new volScalarField
        (
            IOobject
            (
                resultName_,
                time_.timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE
            ),
            mesh_,
            dimensionedScalar(dimless, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    if (!postProcess)
    {
        update();
    }
    return true;
}


void Foam::functionObjects::refinementIndicator::update()
{
    scalarField& values = result_->primitiveFieldRef();
    values = Zero;
    if (const auto* eps = mesh_.cfindObject<volScalarField>("eps"))
    {
        values = max(values, neg(eps->primitiveField() - fluidFraction_));
    }
    if (const auto* locked = mesh_.cfindObject<volScalarField>("locked"))
    {
        values = max(values, locked->primitiveField());
    }
    if (alphaName_ != none)
    {
        const scalarField& alpha =
            mesh_.lookupObject<volScalarField>(alphaName_).primitiveField();
        values = max
        (
            values,
            pos0(alpha - lowerAlpha)*pos0(upperAlpha_ + roundOff - alpha)
        );
    }
    result_->correctBoundaryConditions();
    for (label layer = 0; layer < margin_; ++layer)
    {
        const surfaceScalarField beside(linearInterpolate(result_()));
        values = pos(fvc::surfaceSum(beside)().primitiveField() - SMALL);
        result_->correctBoundaryConditions();
    }
}


bool Foam::functionObjects::refinementIndicator::execute()
{
    update();
    return true;
}
