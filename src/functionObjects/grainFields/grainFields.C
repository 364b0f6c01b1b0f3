/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFields.H"

#include "addToRunTimeSelectionTable.H"
#include "exactOverlaps.H"
#include "functionKeywords.H"
#include "grainSpace.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(grainFields, 0);
    addToRunTimeSelectionTable(functionObject, grainFields, dictionary);
}
}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
Foam::functionObjects::grainFields::field
(
    const word& name,
    const dimensionSet& dimensions
) const
{
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, time_.timeName(), mesh_),
        mesh_,
        dimensioned<Type>(dimensions, Zero),
        "zeroGradient"
    );
}


Foam::functionObjects::grainFields::grainFields
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    packing_(field<scalar>("packing", dimless)),
    UGrains_(field<vector>("UGrains", dimVelocity)),
    grainFlux_(field<vector>("grainFlux", dimVelocity)),
    granularTemperature_
    (
        field<scalar>("granularTemperature", sqr(dimVelocity))
    )
{
    read(dict);
}


bool Foam::functionObjects::grainFields::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {});
    return true;
}


bool Foam::functionObjects::grainFields::execute()
{
    const grainMotion& grains =
        refCast<const grainMotion>(grainView::of(mesh_, name()));

    const overlapList overlaps(exactOverlaps(grains));

    scalarField volume(mesh_.nCells(), Zero);
    vectorField flow(mesh_.nCells(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            volume[o.cell] += o.volume;
            flow[o.cell] += o.volume*grains.motion(graini).velocity;
        }
    }
    vectorField& U = UGrains_.primitiveFieldRef();
    forAll(U, celli)
    {
        U[celli] =
            volume[celli] > 0 ? flow[celli]/volume[celli] : vector(Zero);
    }

    // In a second pass, as the difference of two sums loses its digits
    scalarField squares(mesh_.nCells(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const vector v(grains.motion(graini).velocity);
        for (const cellOverlap& o : overlaps.of(graini))
        {
            squares[o.cell] += o.volume*magSqr(v - U[o.cell]);
        }
    }
    const scalar nComponents = isPlanar(mesh_) ? 2 : 3;
    scalarField& theta = granularTemperature_.primitiveFieldRef();
    forAll(theta, celli)
    {
        theta[celli] =
            volume[celli] > 0
          ? squares[celli]/(nComponents*volume[celli])
          : 0;
    }
    packing_.primitiveFieldRef() = volume/mesh_.V();
    grainFlux_.primitiveFieldRef() = flow/mesh_.V();

    packing_.correctBoundaryConditions();
    UGrains_.correctBoundaryConditions();
    grainFlux_.correctBoundaryConditions();
    granularTemperature_.correctBoundaryConditions();
    return true;
}


bool Foam::functionObjects::grainFields::write()
{
    packing_.write();
    UGrains_.write();
    grainFlux_.write();
    granularTemperature_.write();
    return true;
}
