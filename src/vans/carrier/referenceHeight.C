/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "referenceHeight.H"

#include "fvMesh.H"
#include "uniformDimensionedFields.H"

Foam::dimensionedScalar Foam::ghRef
(
    const fvMesh& mesh,
    const dimensionedVector& g
)
{
    const uniformDimensionedScalarField hRef
    (
        IOobject
        (
            "hRef",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        dimensionedScalar("hRef", dimLength, Zero)
    );
    return
        mag(g.value()) > SMALL
      ? g & (cmptMag(g.value())/mag(g.value()))*hRef
      : dimensionedScalar("ghRef", g.dimensions()*dimLength, Zero);
}
