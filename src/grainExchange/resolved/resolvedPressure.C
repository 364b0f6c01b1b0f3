/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "resolvedGrains.H"

#include "fvcFlux.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceInterpolate.H"

Foam::tmp<Foam::surfaceScalarField> Foam::resolvedGrains::continued
(
    const surfaceScalarField& flux
) const
{
    // Of a face to a grain: counts for a cell that has no other in a direction
    constexpr scalar least = 1e-2;

    const surfaceScalarField fluidPart(fvc::interpolate(1 - locked_));
    const surfaceScalarField beside(lockedFaces_*pos(fluidPart - SMALL));
    const surfaceVectorField weighted
    (
        (1 - (1 - least)*lockedFaces_)*mesh_.Sf()/mesh_.magSf()
    );
    volVectorField gradient
    (
        "continued",
        inv(fvc::surfaceSum(weighted*mesh_.Sf()))
      & fvc::surfaceSum(weighted*flux)
    );
    gradient.correctBoundaryConditions();

    return beside
       *(
            fvc::flux((1 - locked_)*gradient)/max(fluidPart, scalar(SMALL))
          - flux
        );
}
