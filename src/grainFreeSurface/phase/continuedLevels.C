/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "continuedFraction.H"

#include "fvc.H"
#include "gaussLaplacianScheme.H"
#include "localMax.H"
#include "localMin.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

volScalarField plain
(
    const fvMesh& mesh,
    const word& name,
    const scalarField& values
)
{
    volScalarField x
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimless,
        zeroGradientFvPatchScalarField::typeName
    );
    x.primitiveFieldRef() = values;
    x.correctBoundaryConditions();
    return x;
}


//- Call f(cell, values of the other cell...) for both sides of each face with
//  two cells
template<class Function>
void forSides(const volScalarField& x, const volScalarField& y, const Function& f)
{
    const fvMesh& mesh = x.mesh();
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        f(P, x[N], y[N]);
        f(N, x[P], y[P]);
    }
    forAll(x.boundaryField(), patchi)
    {
        if (!x.boundaryField()[patchi].coupled())
        {
            continue;
        }
        const labelUList& cells = mesh.boundary()[patchi].faceCells();
        const scalarField xN(x.boundaryField()[patchi].patchNeighbourField());
        const scalarField yN(y.boundaryField()[patchi].patchNeighbourField());
        forAll(cells, i)
        {
            f(cells[i], xN[i], yN[i]);
        }
    }
}

}


void Foam::continuedFraction::harmonic
(
    const surfaceScalarField& weight,
    const scalar deflt,
    volScalarField& x
) const
{
    // Of the diagonal, so that what nothing is near has a value
    constexpr scalar least = 1e-10;

    tmp<fvScalarMatrix> tequation
    (
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            weight*mesh_.magSf(), mesh_.nonOrthDeltaCoeffs(), x
        )
    );
    const scalarField size
    (
        fvc::surfaceSum
        (
            mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
        )().primitiveField()
    );
    tequation.ref().diag() -= least*size;
    tequation.ref().source() -= least*size*deflt;
    solveCovered(tequation.ref());
    x.correctBoundaryConditions();
}


void Foam::continuedFraction::continueLevels
(
    const volScalarField& alpha,
    volScalarField& continued
) const
{
    // A level is as good as what it says of the cells around: below the first
    // difference of their shares it counts alone, from the second on not at all
    constexpr scalar trusted = 0.1, useless = 0.3;

    volScalarField isCovered
    (
        plain(mesh_, "isCovered", scalarField(mesh_.nCells(), Zero))
    );
    for (const label celli : covered_)
    {
        isCovered[celli] = 1;
    }
    isCovered.correctBoundaryConditions();

    // From cells that have a surface
    const volScalarField cellLevels(levels_.levels(alpha));
    scalarField weights(mesh_.nCells());
    forAll(weights, celli)
    {
        weights[celli] =
            isCovered[celli] > 0 ? 0 : 4*surfaceLevels::weight(alpha[celli]);
    }
    const scalar mean =
        gSum(weights*cellLevels.primitiveField())/max(gSum(weights), VSMALL);
    volScalarField level
    (
        plain(mesh_, "levelContinued", cellLevels.primitiveField() - mean)
    );
    weights = max(weights, isCovered.primitiveField());
    harmonic
    (
        localMin<scalar>(mesh_).interpolate(plain(mesh_, "weights", weights)),
        0, level
    );

    // What the levels say of the open cells around
    scalarField miss(mesh_.nCells(), Zero);
    forSides
    (
        level, isCovered,
        [&](const label celli, const scalar levelN, const scalar coveredN)
        {
            if (coveredN > 0 && isCovered[celli] < 1)
            {
                miss[celli] = max
                (
                    miss[celli],
                    mag(levels_.share(celli, levelN + mean) - alpha[celli])
                );
            }
        }
    );
    volScalarField error(plain(mesh_, "missOfLevel", miss));
    harmonic
    (
        surfaceScalarField(pos(mesh_.magSf())), 1, error
    );

    for (const label celli : covered_)
    {
        const scalar trust = max
        (
            min((useless - error[celli])/(useless - trusted), scalar(1)),
            scalar(0)
        );
        continued[celli] +=
            trust
           *(levels_.share(celli, level[celli] + mean) - continued[celli]);
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::offLevel
(
    const volScalarField& alpha
) const
{
    // Differences of shares from which fluid changes places, and all of it does:
    // for less, what changes places would make them larger
    constexpr scalar none = 0.2, all = 0.5;

    // Two cells of one fluid have no surface
    constexpr scalar same = 1e-9;

    const volScalarField levels(levels_.levels(alpha));
    const volScalarField held(plain(mesh_, "held", alpha.primitiveField()));
    volScalarField miss
    (
        plain(mesh_, "missOfLevel", scalarField(mesh_.nCells(), Zero))
    );
    forSides
    (
        held, levels,
        [&](const label celli, const scalar alphaN, const scalar levelN)
        {
            const scalar P = surfaceLevels::weight(alpha[celli]);
            const scalar N = surfaceLevels::weight(alphaN);
            if (mag(alpha[celli] - alphaN) < same)
            {
                return;
            }
            const scalar level = (P*levels[celli] + N*levelN)/(P + N);
            miss[celli] = max
            (
                miss[celli],
                mag(levels_.share(celli, level) - alpha[celli])
            );
        }
    );
    miss.correctBoundaryConditions();
    return min
    (
        max
        (
            (localMax<scalar>(mesh_).interpolate(miss) - none)/(all - none),
            scalar(0)
        ),
        scalar(1)
    );
}
