/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "continuedFraction.H"

#include "fvc.H"
#include "gaussLaplacianScheme.H"
#include "localMin.H"
#include "syncTools.H"
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


scalar faceValue(const surfaceScalarField& x, const label facei)
{
    if (x.mesh().isInternalFace(facei))
    {
        return x[facei];
    }
    const label patchi = x.mesh().boundaryMesh().whichPatch(facei);
    const fvsPatchScalarField& patch = x.boundaryField()[patchi];
    return patch.size() ? patch[facei - patch.patch().start()] : 0;
}


//- Call f(face, cell, values of the other cell...) for both sides of each face
//  with two cells
template<class Function>
void forSides(const volScalarField& x, const volScalarField& y, const Function& f)
{
    const fvMesh& mesh = x.mesh();
    forAll(mesh.neighbour(), facei)
    {
        const label P = mesh.owner()[facei], N = mesh.neighbour()[facei];
        f(facei, P, x[N], y[N]);
        f(facei, N, x[P], y[P]);
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
            f(mesh.boundary()[patchi].start() + i, cells[i], xN[i], yN[i]);
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
        [&]
        (
            const label, const label celli,
            const scalar levelN, const scalar coveredN
        )
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


Foam::scalarField Foam::continuedFraction::missOfFaces
(
    const volScalarField& alpha,
    const surfaceScalarField& faces
) const
{
    // Levels of the cells of these faces, for the other side, too
    volScalarField level
    (
        plain(mesh_, "levelOfFaces", scalarField(mesh_.nCells(), Zero))
    );
    forAll(level, celli)
    {
        for (const label facei : mesh_.cells()[celli])
        {
            if (faceValue(faces, facei) > 0)
            {
                level[celli] = levels_.level(celli, alpha[celli]);
                break;
            }
        }
    }
    level.correctBoundaryConditions();
    const volScalarField held(plain(mesh_, "held", alpha.primitiveField()));

    scalarField miss(mesh_.nFaces(), Zero);
    forSides
    (
        held, level,
        [&]
        (
            const label facei, const label celli,
            const scalar alphaN, const scalar levelN
        )
        {
            if (faceValue(faces, facei) > 0 && alpha[celli] != alphaN)
            {
                const scalar P = surfaceLevels::weight(alpha[celli]);
                const scalar N = surfaceLevels::weight(alphaN);
                const scalar common = (P*level[celli] + N*levelN)/(P + N);
                miss[facei] = max
                (
                    miss[facei],
                    mag(levels_.share(celli, common) - alpha[celli])
                );
            }
        }
    );
    syncTools::syncFaceList(mesh_, miss, maxEqOp<scalar>());
    return miss;
}


Foam::tmp<Foam::surfaceScalarField> Foam::continuedFraction::offLevel
(
    const volScalarField& alpha,
    const surfaceScalarField& faces
) const
{
    // Differences of shares from which fluid changes places, and all of it does:
    // for less, what changes places would make them larger
    constexpr scalar none = 0.2, all = 0.5;

    const scalarField miss(missOfFaces(alpha, faces));
    tmp<surfaceScalarField> tresult(new surfaceScalarField(0*faces));
    surfaceScalarField& result = tresult.ref();
    const auto part = [&](const label facei)
    {
        return max(min((miss[facei] - none)/(all - none), scalar(1)), scalar(0));
    };
    forAll(result, facei)
    {
        result[facei] = part(facei);
    }
    for (fvsPatchScalarField& patch : result.boundaryFieldRef())
    {
        forAll(patch, i)
        {
            patch[i] = part(patch.patch().start() + i);
        }
    }
    return tresult;
}
