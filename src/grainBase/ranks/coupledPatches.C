/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledPatches.H"

namespace
{

using namespace Foam;

template<class Type>
void evaluateAll(const fvMesh& mesh)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    // Old times have names of their own there
    for (const word& name : mesh.sortedNames<fieldType>())
    {
        evaluateCoupled(mesh.lookupObjectRef<fieldType>(name));
    }
}

}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& Foam::evaluateCoupled
(
    GeometricField<Type, fvPatchField, volMesh>& field
)
{
    const label nRequests = Pstream::nRequests();
    auto& patches = field.boundaryFieldRef();
    for (fvPatchField<Type>& patch : patches)
    {
        if (patch.coupled())
        {
            patch.initEvaluate(Pstream::commsTypes::nonBlocking);
        }
    }
    Pstream::waitRequests(nRequests);
    for (fvPatchField<Type>& patch : patches)
    {
        if (patch.coupled())
        {
            patch.evaluate(Pstream::commsTypes::nonBlocking);
        }
    }
    if (field.nOldTimes())
    {
        evaluateCoupled(field.oldTime());
    }
    return field;
}


void Foam::evaluateCoupled(const fvMesh& mesh)
{
    evaluateAll<scalar>(mesh);
    evaluateAll<vector>(mesh);
    evaluateAll<symmTensor>(mesh);
    evaluateAll<tensor>(mesh);
}


template Foam::volScalarField& Foam::evaluateCoupled(volScalarField&);
template Foam::volVectorField& Foam::evaluateCoupled(volVectorField&);
