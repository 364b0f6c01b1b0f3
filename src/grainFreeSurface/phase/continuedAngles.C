/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "continuedFraction.H"

#include "fvc.H"
#include "gaussConvectionScheme.H"
#include "gaussGrad.H"
#include "gaussLaplacianScheme.H"
#include "upwind.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

volVectorField directions(const fvMesh& mesh, const word& name)
{
    return volVectorField
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimless, Zero),
        zeroGradientFvPatchVectorField::typeName
    );
}


//- Mean of the directions of a face's cells that have one, through the face
scalar through(const vector& P, const vector& N, const vector& S)
{
    const vector sum(P + N);
    const bool isOne = magSqr(P) < SMALL || magSqr(N) < SMALL;
    return (isOne ? 1 : 0.5)*(sum & S);
}


//- Directions of cells through faces between two cells
tmp<surfaceScalarField> throughFaces(const volVectorField& way)
{
    const fvMesh& mesh = way.mesh();
    tmp<surfaceScalarField> tresult
    (
        new surfaceScalarField
        (
            IOobject("throughFaces", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimArea, Zero)
        )
    );
    surfaceScalarField& result = tresult.ref();
    result.setOriented();
    forAll(mesh.neighbour(), facei)
    {
        result[facei] = through
        (
            way[mesh.owner()[facei]], way[mesh.neighbour()[facei]],
            mesh.Sf()[facei]
        );
    }
    forAll(way.boundaryField(), patchi)
    {
        const fvPatchVectorField& patch = way.boundaryField()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField P(patch.patchInternalField());
        const vectorField N(patch.patchNeighbourField());
        forAll(P, i)
        {
            result.boundaryFieldRef()[patchi][i] =
                through(P[i], N[i], mesh.Sf().boundaryField()[patchi][i]);
        }
    }
    return tresult;
}

}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::intoGrains
(
    const volScalarField& continued,
    const labelList& cells,
    const scalarField& curvature,
    boolList& isWetted
) const
{
    const scalar small = 1e-8/cbrt(gAverage(mesh_.V().field()));

    const volVectorField gradient
    (
        fv::gaussGrad<scalar>(mesh_).calcGrad(continued, "gradOfContinued")
    );
    volVectorField way(directions(mesh_, "intoGrain"));
    scalarField sine(mesh_.nCells(), Zero);
    wetting_.set(curvature, way, sine);

    for (const label celli : cells)
    {
        const vector n(way[celli]);
        isWetted[celli] = magSqr(n) > 0.5;
        const vector along(gradient[celli] - (gradient[celli] & n)*n);
        way[celli] = -
        (
            sqrt(1 - sqr(sine[celli]))*n
          + sine[celli]*along/(mag(along) + small)
        );
    }
    forAll(way, celli)
    {
        if (!isWetted[celli])
        {
            way[celli] = Zero;
        }
    }
    way.correctBoundaryConditions();
    return throughFaces(way);
}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::beyondUpwind
(
    const surfaceScalarField& into,
    const volScalarField& continued
) const
{
    const volVectorField gradient
    (
        fv::gaussGrad<scalar>(mesh_).calcGrad(continued, "gradOfContinued")
    );
    const upwind<vector> scheme(mesh_, into);
    surfaceVectorField arm(mesh_.Cf() - scheme.interpolate(mesh_.C()));

    // Across a period centres are not where they are seen from the other side
    forAll(arm.boundaryField(), patchi)
    {
        fvsPatchVectorField& patch = arm.boundaryFieldRef()[patchi];
        if (patch.coupled())
        {
            const vectorField toFaces
            (
                patch.patch().Cf() - patch.patch().Cn()
            );
            patch == toFaces
              - neg(into.boundaryField()[patchi])*patch.patch().delta();
        }
    }
    return scheme.interpolate(gradient) & arm;
}


void Foam::continuedFraction::continueAngles
(
    const labelList& cells,
    const scalarField& curvature,
    volScalarField& continued
) const
{
    // Share of faces in all directions, for cells to which no way leads
    constexpr scalar least = 1e-6;

    // Solutions that take the gradient upwind into account
    constexpr label nCorrections = 4;

    boolList isWetted(mesh_.nCells(), false);
    continued.correctBoundaryConditions();
    const surfaceScalarField into
    (
        intoGrains(continued, cells, curvature, isWetted)
    );

    tmp<fvScalarMatrix> tequation
    (
        fv::gaussConvectionScheme<scalar>
        (
            mesh_, into, tmp<surfaceInterpolationScheme<scalar>>
            (
                new upwind<scalar>(mesh_, into)
            )
        ).fvmDiv(into, continued)
    );
    fvScalarMatrix& equation = tequation.ref();
    equation.diag() -=
        fvc::surfaceIntegrate(into)().primitiveField()*mesh_.V().field();
    equation -=
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            least*mesh_.magSf()/mesh_.nonOrthDeltaCoeffs(),
            mesh_.nonOrthDeltaCoeffs(), continued
        );
    confine(isWetted, equation);
    const scalarField atFirst(equation.source());

    dictionary controls;
    controls.add("solver", "PBiCGStab");
    controls.add("preconditioner", "DILU");
    controls.add("tolerance", tolerance);
    controls.add("relTol", 0);
    for (label i = 0; i <= nCorrections; ++i)
    {
        if (i > 0)
        {
            const scalarField beyond
            (
                fvc::surfaceIntegrate
                (
                    into*beyondUpwind(into, continued)
                )().primitiveField()*mesh_.V().field()
            );
            forAll(beyond, celli)
            {
                if (isWetted[celli])
                {
                    equation.source()[celli] = atFirst[celli] - beyond[celli];
                }
            }
        }
        equation.solve(controls);
        continued.primitiveFieldRef() =
            max(min(continued.primitiveField(), scalar(1)), scalar(0));
        continued.correctBoundaryConditions();
    }
}
