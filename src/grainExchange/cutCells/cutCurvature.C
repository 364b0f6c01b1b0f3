/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutCurvature.H"

#include "zeroGradientFvPatchFields.H"

namespace
{

template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh> field
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::dimensionSet& dimensions
)
{
    using namespace Foam;
    return GeometricField<Type, fvPatchField, volMesh>
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensioned<Type>("none", dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
}

}


Foam::cutCurvature::cutCurvature(const cutCells& cells, const fvMesh& mesh)
:
    cells_(cells),
    mesh_(mesh),
    second_(field<vector>("cutSecond", mesh, dimVelocity/dimArea)),
    axes_(field<symmTensor>("cutAxes", mesh, dimless)),
    spread_(field<symmTensor>("cutSpread", mesh, dimArea))
{
    forAll(spread_, celli)
    {
        spread_[celli] = cells.spreadOfWhole(celli);
    }
}


void Foam::cutCurvature::add(const cutCells::wall& x, const vector& second)
{
    // Below this share of fluid a cell follows its walls, and what its velocity
    // has of a curvature is small against its errors
    constexpr scalar small = 0.1;

    const symmTensor axis(sqr(x.normal));
    const scalar whole = axis && cells_.spreadOfWhole(x.cell);
    second_[x.cell] +=
        x.share*min(cells_.fluid()[x.cell]/small, scalar(1))*second;
    axes_[x.cell] += x.share*axis;
    spread_[x.cell] += x.share*(cells_.spreadAlong(x) - whole)*axis;
}


Foam::vector Foam::cutCurvature::missing
(
    const side& own,
    const side& other,
    const vector& way,
    const scalar share
)
{
    const auto along = [&](const side& of)
    {
        return
            of.weight
           *(
                (way & (of.axes & way))*(1 - 2*share)
              + (of.axes && (other.spread - own.spread))
            )
           *of.second;
    };
    const scalar weights = own.weight + other.weight;
    return
        weights > SMALL
      ? vector(-0.5*(along(own) + along(other))/weights)
      : vector(Zero);
}


Foam::tmp<Foam::surfaceVectorField> Foam::cutCurvature::flux
(
    const surfaceScalarField& mu
) const
{
    volVectorField second(second_);
    volSymmTensorField axes(axes_);
    volSymmTensorField spread(spread_);
    second.correctBoundaryConditions();
    axes.correctBoundaryConditions();
    spread.correctBoundaryConditions();

    const volScalarField& fluid = cells_.fluid();
    const surfaceVectorField way(cells_.ways());
    const auto of = [&](const label celli)
    {
        return side
        {
            second[celli], axes[celli], spread[celli], 1 - fluid[celli]
        };
    };
    const auto share = [&](const label celli, const point& x, const vector& n, const vector& d)
    {
        const scalar along = (x - cells_.centroid(celli)) & n;
        return min(max(along/max(d & n, VSMALL), scalar(0)), scalar(1));
    };

    surfaceVectorField result
    (
        IOobject("cutCurvature", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimVelocity, Zero)
    );
    forAll(mesh_.owner(), i)
    {
        const label P = mesh_.owner()[i];
        const vector n(mesh_.Sf()[i]/mesh_.magSf()[i]);
        result[i] = missing
        (
            of(P), of(mesh_.neighbour()[i]), way[i],
            share(P, mesh_.Cf()[i], n, way[i])
        );
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField n(patch.nf());
        const vectorField d(way.boundaryField()[patchi]);
        const vectorField secondN(second.boundaryField()[patchi].patchNeighbourField());
        const symmTensorField axesN(axes.boundaryField()[patchi].patchNeighbourField());
        const symmTensorField spreadN(spread.boundaryField()[patchi].patchNeighbourField());
        const scalarField fluidN(fluid.boundaryField()[patchi].patchNeighbourField());
        forAll(n, i)
        {
            const label P = patch.faceCells()[i];
            result.boundaryFieldRef()[patchi][i] = missing
            (
                of(P), {secondN[i], axesN[i], spreadN[i], 1 - fluidN[i]}, d[i],
                share(P, patch.Cf()[i], n[i], d[i])
            );
        }
    }
    return
        cells_.conductance()*mesh_.nonOrthDeltaCoeffs()*mu*mesh_.magSf()*result;
}
