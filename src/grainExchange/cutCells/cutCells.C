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


//- Mean of the square of the way from the centre of a cell, exact for a box
Foam::symmTensorField spreadOfCells(const Foam::fvMesh& mesh)
{
    using namespace Foam;
    symmTensorField result(mesh.nCells(), Zero);
    const auto add = [&](const label celli, const label facei, const scalar sign)
    {
        const vector x(mesh.faceCentres()[facei] - mesh.C()[celli]);
        result[celli] +=
            sign*(x & mesh.faceAreas()[facei])/(3*mesh.V()[celli])*sqr(x);
    };
    forAll(mesh.faceOwner(), facei)
    {
        add(mesh.faceOwner()[facei], facei, 1);
    }
    forAll(mesh.faceNeighbour(), facei)
    {
        add(mesh.faceNeighbour()[facei], facei, -1);
    }
    return result;
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
    spread_(spreadOfCells(mesh_)),
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


Foam::scalar Foam::cutCells::halfFilm(const wall& x) const
{
    const scalar V = mesh_.V()[x.cell];
    return 0.5*fluid_[x.cell]*V/max(mag(x.area), V/cellSize_[x.cell]);
}


Foam::scalar Foam::cutCells::spreadAlong(const wall& x) const
{
    // Between a third of the square, of a film, and a half, of the tip of a wedge
    return min
    (
        (0.5 - 0.25*fluid_[x.cell])*sqr(x.distance),
        x.normal & (spread_[x.cell] & x.normal)
    );
}


Foam::tmp<Foam::surfaceVectorField> Foam::cutCells::ways() const
{
    tmp<surfaceVectorField> tway(new surfaceVectorField(mesh_.delta()()));
    surfaceVectorField& way = tway.ref();
    forAll(mesh_.owner(), i)
    {
        way[i] += centroid_[mesh_.neighbour()[i]] - centroid_[mesh_.owner()[i]];
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        fvsPatchVectorField& atPatch = way.boundaryFieldRef()[patchi];
        if (patch.coupled())
        {
            const fvPatchVectorField& x = centroid_.boundaryField()[patchi];
            atPatch += x.patchNeighbourField() - x.patchInternalField();
        }
        else
        {
            atPatch = patch.nf();
        }
    }
    return tway;
}


Foam::scalarField Foam::cutCells::solid() const
{
    scalarField result(mesh_.nCells(), Zero);
    forGrains
    (
        [&](const label graini)
        {
            for (const cellOverlap& o : grains_.overlaps().of(graini))
            {
                result[o.cell] += o.volume;
            }
        }
    );
    return result;
}


void Foam::cutCells::setCells()
{
    const scalarField& V = mesh_.V();
    const vectorField& C = mesh_.C();

    const scalarField solid(this->solid());
    vectorField moment(mesh_.nCells(), Zero);
    forGrains
    (
        [&](const label graini)
        {
            for (const cellOverlap& o : grains_.overlaps().of(graini))
            {
                moment[o.cell] +=
                    o.volume
                   *(o.arm - between(grains_.centres()[graini], C[o.cell]));
            }
        }
    );
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


void Foam::cutCells::update(const boolList& isResolved)
{
    isResolved_ = isResolved;
    setCells();
    setFaces();
    setWalls();
    leavePatches();
    setConductance();
}
