/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCells.H"

#include "cellSizes.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

template<class Type, template<class> class Patch, class Mesh>
Foam::GeometricField<Type, Patch, Mesh> cutField
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::dimensioned<Type>& value,
    const Foam::word& patchType
)
{
    using namespace Foam;
    return GeometricField<Type, Patch, Mesh>
    (
        IOobject(name, mesh.time().timeName(), mesh), mesh, value, patchType
    );
}


Foam::volScalarField cutCellField(const Foam::word& name, const Foam::fvMesh& mesh)
{
    using namespace Foam;
    return cutField<scalar, fvPatchField, volMesh>
    (
        name, mesh, dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    );
}


Foam::surfaceScalarField cutFaceField
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::scalar value
)
{
    using namespace Foam;
    return cutField<scalar, fvsPatchField, surfaceMesh>
    (
        name, mesh, dimensionedScalar("value", dimless, value),
        calculatedFvsPatchField<scalar>::typeName
    );
}

}


Foam::cutCells::cutCells(const grainSystem& grains)
:
    grains_(grains),
    mesh_(grains.mesh()),
    cellSize_(cellSizes(mesh_)),
    open_(cutFaceField("openFaces", mesh_, 1)),
    fluid_(cutCellField("fluidOfCells", mesh_)),
    centroid_
    (
        cutField<vector, fvPatchField, volMesh>
        (
            "fluidCentroid", mesh_, dimensionedVector(dimLength, Zero),
            zeroGradientFvPatchVectorField::typeName
        )
    ),
    cutFaces_(cutFaceField("cutFaces", mesh_, 0)),
    openCells_(cutCellField("openCells", mesh_)),
    conductance_(cutFaceField("conductance", mesh_, 1))
{}


Foam::vector Foam::cutCells::inMesh(const vector& x) const
{
    vector result(x);
    for (direction i = 0; i < vector::nComponents; ++i)
    {
        if (mesh_.geometricD()[i] < 0)
        {
            result[i] = 0;
        }
    }
    return result;
}


void Foam::cutCells::setCells()
{
    const overlapList& overlaps = grains_.overlaps();
    const scalarField& V = mesh_.V();
    const vectorField& C = mesh_.C();

    scalarField solid(mesh_.nCells(), Zero);
    vectorField moment(mesh_.nCells(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            solid[o.cell] += o.volume;
            moment[o.cell] +=
                o.volume
               *(o.arm - between(grains_.centres()[graini], C[o.cell]));
        }
    }
    forAll(solid, celli)
    {
        const scalar room = 1 - solid[celli]/V[celli];
        const bool isClosed = room < least_;
        fluid_[celli] = isClosed ? 0 : room;
        centroid_[celli] =
            isClosed ? vector(Zero) : vector(-moment[celli]/(room*V[celli]));
    }
    fluid_.correctBoundaryConditions();
    centroid_.correctBoundaryConditions();
}


void Foam::cutCells::update()
{
    setCells();
    setFaces();
    setWalls();
    leavePatches();
    setConductance();
}
