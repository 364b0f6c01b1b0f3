/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "fvc.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

//- Sum of the fourth powers of the components of a unit vector along the axes of
//  a cell, which are the normals of its faces
Foam::scalar fourthPowers
(
    const Foam::fvMesh& mesh,
    const Foam::label celli,
    const Foam::vector& direction
)
{
    Foam::scalar squares = 0, fourth = 0;
    for (const Foam::label facei : mesh.cells()[celli])
    {
        const Foam::vector n(normalised(mesh.faceAreas()[facei]));
        squares += Foam::sqr(n & direction);
        fourth += Foam::pow4(n & direction);
    }
    return fourth/squares;
}

}


Foam::tmp<Foam::volVectorField> Foam::cutGrains::normals() const
{
    tmp<volVectorField> tnormals
    (
        new volVectorField
        (
            IOobject("cutNormals", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(dimless, Zero),
            zeroGradientFvPatchVectorField::typeName
        )
    );
    volVectorField& normals = tnormals.ref();
    for (const cutCells::wall& w : cells_.walls())
    {
        if (cells_.fluid()[w.cell] > 0)
        {
            normals[w.cell] += w.share*w.arm/mag(w.arm);
        }
    }

    // Of the cells beside them, and of those beside these
    for (label layer = 0; layer < 2; ++layer)
    {
        normals.correctBoundaryConditions();
        const volVectorField beside
        (
            fvc::surfaceSum(fvc::interpolate(normals))
        );
        forAll(normals, celli)
        {
            if (normals[celli] == vector(Zero) && cells_.fluid()[celli] == 1)
            {
                normals[celli] = normalised(beside[celli]);
            }
        }
    }
    normals.correctBoundaryConditions();
    return tnormals;
}


void Foam::cutGrains::setSlip(const volVectorField& U) const
{
    slip_ = Zero;
    const volVectorField n(normals());
    volVectorField slope(n & gradient(U, false));
    slope.correctBoundaryConditions();
    const volVectorField curvature(n & gradient(slope, true));
    const volScalarField isWhole(pos(cells_.fluid() - 1 + SMALL)*mag(n));
    const surfaceScalarField wholes(fvc::interpolate(isWhole));
    const volScalarField number(fvc::surfaceSum(cells_.open()*wholes));
    const volVectorField all
    (
        fvc::surfaceSum(cells_.open()*fvc::interpolate(isWhole*curvature))
    );
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const label c = walls[i].cell;
        if (link_[i] > 0 && number[c] > SMALL)
        {
            const vector m(walls[i].arm/mag(walls[i].arm));
            slip_[i] =
                (1 + 2*fourthPowers(mesh_, c, m))/24
               *sqr(cells_.cellSize(c))*all[c]/number[c];
        }
    }
}
