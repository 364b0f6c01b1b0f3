/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reconstruction.H"

#include "extrapolatedCalculatedFvPatchFields.H"
#include "surfaceInterpolate.H"
#include "fvcSurfaceIntegrate.H"

namespace Foam
{
    defineTypeName(reconstruction);
}


Foam::tmp<Foam::surfaceVectorField> Foam::reconstruction::normals() const
{
    return mesh_.Sf()/mesh_.magSf();
}


Foam::tmp<Foam::volTensorField> Foam::reconstruction::inverses() const
{
    return inv(fvc::surfaceSum(normal_*mesh_.Sf()));
}


Foam::reconstruction::reconstruction(const fvMesh& mesh)
:
    MeshObject<fvMesh, MoveableMeshObject, reconstruction>(mesh),
    normal_(normals()),
    inverse_(inverses())
{}


Foam::tmp<Foam::volVectorField> Foam::reconstruction::of
(
    const surfaceScalarField& flux
) const
{
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject
            (
                "reconstructed(" + flux.name() + ')', flux.instance(), mesh_
            ),
            inverse_ & fvc::surfaceSum(normal_*flux),
            extrapolatedCalculatedFvPatchVectorField::typeName
        )
    );
    tresult.ref().correctBoundaryConditions();
    return tresult;
}


Foam::tmp<Foam::volTensorField> Foam::reconstruction::mean
(
    const surfaceScalarField& ofFaces
) const
{
    return inverse_ & fvc::surfaceSum(normal_*(ofFaces*mesh_.Sf()));
}


bool Foam::reconstruction::movePoints()
{
    normal_ = normals();
    inverse_ = inverses();
    return true;
}
