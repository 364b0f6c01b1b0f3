/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutGrains.H"

#include "fvc.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

//- Least squares for the gradient of a velocity at a point: sum of x x and x u
//  over points at a distance x, each divided by |x|^2
struct slopes
{
    Foam::symmTensor ways = Foam::symmTensor::zero;
    Foam::tensor rises = Foam::tensor::zero;

    void add(const Foam::vector& way, const Foam::vector& rise)
    {
        const Foam::scalar weight = 1/Foam::max(magSqr(way), Foam::VSMALL);
        ways += weight*sqr(way);
        rises += weight*(way*rise);
    }

    //- None in directions in which there are no points
    Foam::tensor gradient(const Foam::vector& acrossMesh) const
    {
        using namespace Foam;
        constexpr scalar least = 1e-4;

        if (tr(ways) == 0)
        {
            return tensor::zero;
        }
        const symmTensor all
        (
            ways + least*tr(ways)*symmTensor(I) + sqr(acrossMesh)
        );
        return inv(all) & rises;
    }
};

}


Foam::tmp<Foam::volTensorField> Foam::cutGrains::gradient
(
    const volVectorField& U
) const
{
    const scalarField& fluid = cells_.fluid();
    List<slopes> of(mesh_.nCells());
    forNeighbours
    (
        U,
        [&](const label c, const neighbour& x)
        {
            of[c].add(x.way, x.velocity - U[c]);
        }
    );
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            continue;
        }
        const fvPatchVectorField& boundary = U.boundaryField()[patchi];
        const vectorField way(patch.delta());
        forAll(way, i)
        {
            const label c = patch.faceCells()[i];
            of[c].add(way[i] - cells_.shift()[c], boundary[i] - U[c]);
        }
    }
    const List<cutCells::wall>& walls = cells_.walls();
    forAll(walls, i)
    {
        const cutCells::wall& w = walls[i];
        if (fluid[w.cell] > 0)
        {
            const vector n(w.arm/mag(w.arm));
            of[w.cell].add(-w.distance*n, velocityAt(i) - U[w.cell]);
        }
    }

    tmp<volTensorField> tgradient
    (
        new volTensorField
        (
            IOobject("cutGradient", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedTensor(U.dimensions()/dimLength, Zero),
            zeroGradientFvPatchTensorField::typeName
        )
    );
    const vector across(vector::one - cells_.inMesh(vector::one));
    forAll(of, celli)
    {
        if (fluid[celli] > 0)
        {
            tgradient.ref()[celli] = of[celli].gradient(across);
        }
    }
    tgradient.ref().correctBoundaryConditions();
    return tgradient;
}


Foam::tmp<Foam::surfaceVectorField> Foam::cutGrains::besideTheLine
(
    const volVectorField& U,
    const surfaceScalarField& mu
) const
{
    const volScalarField& fluid = cells_.fluid();
    const tmp<volTensorField> tgradient(gradient(U));
    surfaceVectorField n(mesh_.Sf()/mesh_.magSf());
    n.setOriented(false);
    const surfaceTensorField atFaces
    (
        fvc::interpolate(fluid*tgradient())/fluidOfFaces()
    );
    const surfaceVectorField way(cells_.ways());
    const surfaceScalarField perLength
    (
        cells_.conductance()*mesh_.nonOrthDeltaCoeffs()
    );
    return
        cells_.cutFaces()*mu*mesh_.magSf()
       *(cells_.open()*(n & atFaces) - perLength*(way & atFaces));
}
