/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceInterpolate.H"

namespace
{

//- Nearer, a cell of fluid is as good as locked
constexpr Foam::scalar leastFluidPart = 0.05;

//- 1 for cells none of whose faces has the value 1, 0 for others
Foam::tmp<Foam::scalarField> noneOf(const Foam::surfaceScalarField& faces)
{
    using namespace Foam;
    return pos(0.5 - fvc::surfaceSum(faces)().primitiveField());
}

}


Foam::scalar Foam::resolvedGrains::fluidPart
(
    const label graini,
    const point& inGrain,
    const point& inFluid
) const
{
    const vector d(inMesh(inFluid - inGrain));
    scalar grainPart = 0;
    for (const grainMember& body : grains_.members(graini))
    {
        const vector r(between(body.centre, inGrain));
        const scalar inside = sqr(body.radius) - magSqr(r);
        if (inside > 0)
        {
            const scalar b = (r & d)/magSqr(d);
            grainPart = max
            (
                grainPart, sqrt(sqr(b) + inside/magSqr(d)) - b
            );
        }
    }
    return max(1 - grainPart, leastFluidPart);
}


Foam::resolvedGrains::link Foam::resolvedGrains::toFluid
(
    const side& inGrain,
    const side& inFluid
) const
{
    const label graini = label(inGrain.grain);
    const scalar part = fluidPart(graini, inGrain.x, inFluid.x);
    const vector d(inMesh(inFluid.x - inGrain.x));
    const vector spin(grains_.motion().spin(graini));

    return
    {
        1/part,
        (1/part - 1)*(spin ^ d),
        0
    };
}


Foam::resolvedGrains::link Foam::resolvedGrains::linkOf
(
    const side& own,
    const side& neighbour
) const
{
    if (own.isLocked() && !neighbour.isLocked())
    {
        link result(toFluid(own, neighbour));
        result.wallJump *= -1;
        return result;
    }
    if (neighbour.isLocked() && !own.isLocked())
    {
        return toFluid(neighbour, own);
    }
    link result{1, Zero, 0};
    if (own.grain == neighbour.grain && !grains_.motion().isFixed())
    {
        const label graini = label(own.grain);
        result.rigidity =
            density_[graini]*sqr(grains_.fluidDiameter(graini))
           /mesh_.time().deltaTValue();
    }
    return result;
}


void Foam::resolvedGrains::setFaces()
{
    lockedFaces_ == dimensionedScalar(dimless, Zero);
    conductance_ == dimensionedScalar("one", dimless, 1);
    wallJump_ == dimensionedVector(dimVelocity, Zero);
    rigidity_ == dimensionedScalar(rigidity_.dimensions(), Zero);
    openCells_ == dimensionedScalar("one", dimless, 1);

    if (!isActive_)
    {
        return;
    }
    forLinks
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label patchi,
            const label facei
        )
        {
            const link l(linkOf(own, nei));
            resolvedFace::at(lockedFaces_, patchi, facei) = 1;
            resolvedFace::at(conductance_, patchi, facei) = l.conductance;
            resolvedFace::at(wallJump_, patchi, facei) = l.wallJump;
            resolvedFace::at(rigidity_, patchi, facei) = l.rigidity;
        }
    );

    // Twice from cell to neighbour
    openCells_.primitiveFieldRef() = noneOf(lockedFaces_);
    openCells_.correctBoundaryConditions();
    openCells_.primitiveFieldRef() =
        noneOf(1 - pos(fvc::interpolate(openCells_) - 1 + SMALL));
}


Foam::tmp<Foam::surfaceScalarField> Foam::resolvedGrains::conductanceOfHeat() const
{
    tmp<surfaceScalarField> tresult(new surfaceScalarField(conductance_));
    if (!isActive_)
    {
        return tresult;
    }
    surfaceScalarField& result = tresult.ref();
    forLinks
    (
        [&]
        (
            const side& own,
            const side& nei,
            const label patchi,
            const label facei
        )
        {
            if (own.isLocked() && nei.isLocked() && own.grain != nei.grain)
            {
                const scalar between =
                    fluidPart(label(own.grain), own.x, nei.x)
                  + fluidPart(label(nei.grain), nei.x, own.x) - 1;
                resolvedFace::at(result, patchi, facei) =
                    1/max(between, leastFluidPart);
            }
        }
    );
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            continue;
        }
        forAll(patch, i)
        {
            const label celli = patch.faceCells()[i];
            if (grain(celli) >= 0)
            {
                result.boundaryFieldRef()[patchi][i] =
                    1/fluidPart(grain(celli), mesh_.C()[celli], patch.Cf()[i]);
            }
        }
    }
    return tresult;
}


Foam::tmp<Foam::surfaceVectorField> Foam::resolvedGrains::faceExcess
(
    const volVectorField& U
) const
{
    tmp<surfaceVectorField> tresult
    (
        new surfaceVectorField
        (
            IOobject("faceExcess", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedVector(dimVelocity, Zero)
        )
    );
    surfaceVectorField& result = tresult.ref();
    const surfaceVectorField jump(fvc::snGrad(U)/mesh_.nonOrthDeltaCoeffs());

    forSurfaceFaces
    (
        [&]
        (
            const side&,
            const side&,
            const label sign,
            const label patchi,
            const label facei
        )
        {
            // From the surface to the fluid's cell, and half of that between
            // the cells
            const scalar c = resolvedFace::at(conductance_, patchi, facei);
            const vector cells(sign*resolvedFace::at(jump, patchi, facei));
            const vector fluid
            (
                cells + sign/c*resolvedFace::at(wallJump_, patchi, facei)
            );
            resolvedFace::at(result, patchi, facei) =
                0.5*cells - min(0.5*c, scalar(2))*fluid;
        }
    );
    return tresult;
}
