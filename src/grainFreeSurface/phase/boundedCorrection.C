/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundedCorrection.H"

#include "fvcSurfaceIntegrate.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

volScalarField ones(const fvMesh& mesh, const word& name)
{
    return volScalarField
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    );
}


//- Volumes per time that faces take from the cells and bring them [m^3/s]
void sums
(
    const surfaceScalarField& flux,
    scalarField& out,
    scalarField& in
)
{
    const fvMesh& mesh = flux.mesh();
    const auto add = [&](const label celli, const scalar leaving)
    {
        (leaving > 0 ? out : in)[celli] += mag(leaving);
    };
    forAll(mesh.neighbour(), facei)
    {
        add(mesh.owner()[facei], flux[facei]);
        add(mesh.neighbour()[facei], -flux[facei]);
    }
    for (const fvsPatchScalarField& patch : flux.boundaryField())
    {
        forAll(patch, i)
        {
            add(patch.patch().faceCells()[i], patch[i]);
        }
    }
}


//- Multiply each flux by the ratio of the cell that it leaves and that of the
//  cell that it comes to, whichever is less
void scale
(
    const volScalarField& out,
    const volScalarField& in,
    surfaceScalarField& flux
)
{
    const fvMesh& mesh = flux.mesh();
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        flux[facei] *= flux[facei] > 0 ? min(out[P], in[N]) : min(in[P], out[N]);
    }
    forAll(flux.boundaryField(), patchi)
    {
        fvsPatchScalarField& f = flux.boundaryFieldRef()[patchi];
        const fvPatchScalarField& outP = out.boundaryField()[patchi];
        const fvPatchScalarField& inP = in.boundaryField()[patchi];
        const scalarField outC(outP.patchInternalField());
        const scalarField inC(inP.patchInternalField());
        const scalarField outN
        (
            f.coupled() ? outP.patchNeighbourField()() : scalarField(f.size(), 1)
        );
        const scalarField inN
        (
            f.coupled() ? inP.patchNeighbourField()() : scalarField(f.size(), 1)
        );
        forAll(f, i)
        {
            f[i] *= f[i] > 0 ? min(outC[i], inN[i]) : min(inC[i], outN[i]);
        }
    }
}

}


void Foam::boundCorrection
(
    const volScalarField& alpha,
    const volScalarField::Internal& share,
    const scalar deltaT,
    surfaceScalarField& correction
)
{
    constexpr scalar tolerance = 1e-10;
    constexpr label mostPasses = 50;

    const fvMesh& mesh = alpha.mesh();
    const scalarField& V = mesh.V().field();
    volScalarField out(ones(mesh, "out")), in(ones(mesh, "in"));

    for (label pass = 0; pass < mostPasses; ++pass)
    {
        const scalarField change
        (
            deltaT*fvc::surfaceIntegrate(correction)().primitiveField()/share
        );
        scalarField leaving, coming;
        bool isAny = false;
        forAll(change, celli)
        {
            const scalar after = alpha[celli] - change[celli];
            const bool isLow = after < min(alpha[celli], scalar(0)) - tolerance;
            const bool isHigh = after > max(alpha[celli], scalar(1)) + tolerance;
            if ((isLow || isHigh) && leaving.empty())
            {
                leaving.resize(V.size(), 0);
                coming.resize(V.size(), 0);
                sums(correction, leaving, coming);
            }
            const scalar room = share[celli]*V[celli]/deltaT;
            out[celli] =
                isLow ? max(alpha[celli], scalar(0))*room/leaving[celli] : 1;
            in[celli] =
                isHigh ? max(1 - alpha[celli], scalar(0))*room/coming[celli] : 1;
            isAny = isAny || isLow || isHigh;
        }
        if (!returnReduce(isAny, orOp<bool>()))
        {
            return;
        }
        out.min(1);
        in.min(1);
        out.correctBoundaryConditions();
        in.correctBoundaryConditions();
        scale(out, in, correction);
    }
}
