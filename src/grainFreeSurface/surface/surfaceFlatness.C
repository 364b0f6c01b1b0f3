/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceLevels.H"

#include "fvc.H"
#include "localMin.H"

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
        mag(gradient & out_)
       /(mag(gradient) + dimensionedScalar("small", gradient.dimensions(), VSMALL))
    );
    return max
    (
        min(max((cosine - steep)/(level - steep), scalar(0)), scalar(1)),
        localMin<scalar>(mesh_).interpolate(evenness(alpha, levels))
    );
}
