/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceLevels.H"

#include "cutCell.H"
#include "wetFaces.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

volScalarField lengths(const fvMesh& mesh, const word& name)
{
    return volScalarField
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
}


//- Is a vector along a direction or across it?
bool isAligned(const vector& x, const vector& direction)
{
    constexpr scalar roundOff = 1e-6;

    const scalar along = mag(x & direction);
    return along < roundOff*mag(x) || mag(x) - along < sqr(roundOff)*mag(x);
}

}


Foam::surfaceLevels::surfaceLevels
(
    const fvMesh& mesh,
    const vector& g,
    const scalar excess
)
:
    mesh_(mesh),
    out_(mag(g) > SMALL && excess != 0 ? -sign(excess)*g/mag(g) : vector(Zero)),
    gravity_(-sign(excess)*mag(g)),
    isNeeded_(!isAlongGravity())
{
    findEnds();
}


void Foam::surfaceLevels::findEnds()
{
    const label nCells = isNeeded_ ? mesh_.nCells() : 0;
    lowest_.resize(nCells);
    highest_.resize(nCells);
    forAll(lowest_, celli)
    {
        const cutCell cell(mesh_, celli, out_);
        lowest_[celli] = cell.level(0);
        highest_[celli] = cell.level(1);
    }
}


bool Foam::surfaceLevels::isAlongGravity() const
{
    bool isAlong = true;
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const vector way
        (
            mesh_.C()[mesh_.neighbour()[facei]] - mesh_.C()[mesh_.owner()[facei]]
        );
        isAlong =
            isAlong
         && isAligned(mesh_.Sf()[facei], out_)
         && isAligned(way, out_);
    }
    return returnReduce(isAlong, andOp<bool>()) || mag(out_) < SMALL;
}


void Foam::surfaceLevels::meshChanged()
{
    isNeeded_ = !isAlongGravity();
    findEnds();
}


Foam::scalar Foam::surfaceLevels::level
(
    const label celli,
    const scalar share
) const
{
    return
        share <= 0 ? lowest_[celli]
      : share >= 1 ? highest_[celli]
      : cutCell(mesh_, celli, out_).level(share);
}


Foam::tmp<Foam::volScalarField> Foam::surfaceLevels::levels
(
    const volScalarField& alpha
) const
{
    tmp<volScalarField> tresult
    (
        new volScalarField(lengths(mesh_, "surfaceLevels"))
    );
    volScalarField& result = tresult.ref();
    forAll(result, celli)
    {
        result[celli] = level(celli, alpha[celli]);
    }
    result.correctBoundaryConditions();
    return tresult;
}


Foam::scalar Foam::surfaceLevels::share
(
    const label celli,
    const scalar height
) const
{
    return cutCell(mesh_, celli, out_).share(height);
}


void Foam::surfaceLevels::limit
(
    const surfaceScalarField& flux,
    const volScalarField& alpha,
    surfaceScalarField& alphaFlux
) const
{
    limitToWetFaces(flux, levels(alpha), alpha, out_, alphaFlux);
}


Foam::tmp<Foam::surfaceScalarField> Foam::surfaceLevels::heights
(
    const volScalarField& alpha,
    const tmp<surfaceScalarField>& ofMesh,
    const scalar reference
) const
{
    tmp<surfaceScalarField> tresult(new surfaceScalarField(ofMesh));
    surfaceScalarField& result = tresult.ref();

    const volScalarField level(levels(alpha));
    const surfaceScalarField flat(flatness(alpha, level));
    const auto blend = [&]
    (
        scalar& gh,
        const scalar alphaP, const scalar alphaN,
        const scalar levelP, const scalar levelN,
        const scalar flat
    )
    {
        const scalar P = weight(alphaP), N = weight(alphaN);
        const scalar height = (P*levelP + N*levelN)/(P + N);
        gh += flat*(gravity_*height - reference - gh);
    };
    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei], N = mesh_.neighbour()[facei];
        blend
        (
            result[facei], alpha[P], alpha[N], level[P], level[N], flat[facei]
        );
    }
    forAll(result.boundaryField(), patchi)
    {
        const fvPatchScalarField& levelP = level.boundaryField()[patchi];
        if (!levelP.coupled())
        {
            continue;
        }
        const scalarField levelN(levelP.patchNeighbourField());
        const scalarField alphaN
        (
            alpha.boundaryField()[patchi].patchNeighbourField()
        );
        forAll(levelN, i)
        {
            const label P = levelP.patch().faceCells()[i];
            blend
            (
                result.boundaryFieldRef()[patchi][i], alpha[P], alphaN[i],
                level[P], levelN[i], flat.boundaryField()[patchi][i]
            );
        }
    }
    return tresult;
}
