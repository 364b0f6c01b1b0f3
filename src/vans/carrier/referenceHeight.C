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
    // Conditions as prghPressure look it up
    if (!mesh.foundObject<uniformDimensionedScalarField>("hRef"))
    {
        auto* registered = new uniformDimensionedScalarField
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
        registered->store();
    }
    const auto& hRef = mesh.lookupObject<uniformDimensionedScalarField>("hRef");
    return
        mag(g.value()) > SMALL
      ? g & (cmptMag(g.value())/mag(g.value()))*hRef
      : dimensionedScalar("ghRef", g.dimensions()*dimLength, Zero);
}
