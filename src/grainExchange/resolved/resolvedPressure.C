/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "byVolume.H"
#include "fvcSurfaceIntegrate.H"

Foam::tmp<Foam::surfaceScalarField> Foam::resolvedGrains::continued
(
    const surfaceScalarField& given,
    const forceOfGrains& grains
) const
{
    // Of a face to a grain: counts for a cell that has no other in a direction
    constexpr scalar least = 1e-2;

    const surfaceScalarField fluidPart(byVolume(1 - locked_));
    const surfaceScalarField beside(lockedFaces_*pos(fluidPart - SMALL));
    const surfaceVectorField weighted
    (
        (1 - (1 - least)*lockedFaces_)*mesh_.Sf()/mesh_.magSf()
    );
    volVectorField sum
    (
        "sum",
        grains.share*fvc::surfaceSum((1 - lockedFaces_)*weighted*given)
      + fvc::surfaceSum(lockedFaces_*weighted*given)
    );
    if (gMax(((1 - locked_)*grains.beta)().primitiveField()) > 0)
    {
        const surfaceVectorField open
        (
            (1 - lockedFaces_)*mesh_.Sf()/mesh_.magSf()
        );
        sum +=
            (fvc::surfaceSum(open*mesh_.Sf()) & grains.b)
          - grains.beta*fvc::surfaceSum(open*grains.flux);
    }
    volVectorField gradient
    (
        "continued", inv(fvc::surfaceSum(weighted*mesh_.Sf())) & sum
    );
    gradient.correctBoundaryConditions();

    return beside
       *(
            fluxByVolume((1 - locked_)*gradient)/max(fluidPart, scalar(SMALL))
          - given
        );
}
