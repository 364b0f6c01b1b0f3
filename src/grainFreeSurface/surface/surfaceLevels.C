/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceLevels.H"

#include "cutCell.H"
#include "fvc.H"
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


Foam::surfaceLevels::surfaceLevels(const fvMesh& mesh, const vector& g)
:
    mesh_(mesh),
    up_(mag(g) > SMALL ? -g/mag(g) : vector(Zero)),
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
        const cutCell cell(mesh_, celli, up_);
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
         && isAligned(mesh_.Sf()[facei], up_)
         && isAligned(way, up_);
    }
    return returnReduce(isAlong, andOp<bool>()) || mag(up_) < SMALL;
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
      : cutCell(mesh_, celli, up_).level(share);
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
    return cutCell(mesh_, celli, up_).share(height);
}


void Foam::surfaceLevels::limit
(
    const surfaceScalarField& flux,
    const volScalarField& alpha,
    surfaceScalarField& alphaFlux
) const
{
    limitToWetFaces(flux, levels(alpha), alpha, up_, alphaFlux);
}


Foam::tmp<Foam::volScalarField> Foam::surfaceLevels::evenness
(
    const volScalarField& alpha,
    const volScalarField& levels
) const
{
    // What hardly holds a surface does not say how steep it is
    constexpr scalar least = 1e-6;

    volScalarField steep("steep", 0*levels/dimensionedScalar("one", dimLength, 1));
    const auto steepness = []
    (
        const scalar alphaP, const scalar alphaN,
        const scalar levelP, const scalar levelN,
        const scalar inverseDistance
    )
    {
        return
            min(weight(alphaP), weight(alphaN)) > least
          ? mag(levelP - levelN)*inverseDistance
          : 0;
    };
    const surfaceScalarField& inverse = mesh_.deltaCoeffs();
    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei], N = mesh_.neighbour()[facei];
        const scalar s = steepness
        (
            alpha[P], alpha[N], levels[P], levels[N], inverse[facei]
        );
        steep[P] = max(steep[P], s);
        steep[N] = max(steep[N], s);
    }
    forAll(levels.boundaryField(), patchi)
    {
        const fvPatchScalarField& level = levels.boundaryField()[patchi];
        if (!level.coupled())
        {
            continue;
        }
        const scalarField levelN(level.patchNeighbourField());
        const scalarField alphaN
        (
            alpha.boundaryField()[patchi].patchNeighbourField()
        );
        forAll(levelN, i)
        {
            const label P = level.patch().faceCells()[i];
            steep[P] = max
            (
                steep[P],
                steepness
                (
                    alpha[P], alphaN[i], levels[P], levelN[i],
                    inverse.boundaryField()[patchi][i]
                )
            );
        }
    }
    tmp<volScalarField> tresult
    (
        new volScalarField
        (
            "evenness", min(max(2 - 2*steep, scalar(0)), scalar(1))
        )
    );
    tresult.ref().correctBoundaryConditions();
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::surfaceLevels::flatness
(
    const volScalarField& alpha,
    const volScalarField& levels
) const
{
    // Cosines of slopes of 45 and 65 degrees
    constexpr scalar level = 0.7, steep = 0.42;

    const surfaceVectorField gradient(fvc::interpolate(fvc::grad(alpha)));
    const surfaceScalarField cosine
    (
        mag(gradient & up_)
       /(mag(gradient) + dimensionedScalar("small", gradient.dimensions(), VSMALL))
    );
    tmp<surfaceScalarField> tresult
    (
        min(max((cosine - steep)/(level - steep), scalar(0)), scalar(1))
    );
    surfaceScalarField& result = tresult.ref();

    const volScalarField even(evenness(alpha, levels));
    forAll(mesh_.neighbour(), facei)
    {
        const label P = mesh_.owner()[facei], N = mesh_.neighbour()[facei];
        result[facei] = max(result[facei], min(even[P], even[N]));
    }
    forAll(even.boundaryField(), patchi)
    {
        const fvPatchScalarField& evenP = even.boundaryField()[patchi];
        if (evenP.coupled())
        {
            fvsPatchScalarField& patch = result.boundaryFieldRef()[patchi];
            patch = max
            (
                patch,
                min(evenP.patchInternalField()(), evenP.patchNeighbourField()())
            );
        }
    }
    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::surfaceLevels::heights
(
    const volScalarField& alpha,
    const tmp<surfaceScalarField>& ofMesh,
    const scalar gravity,
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
        gh += flat*(-gravity*height - reference - gh);
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
