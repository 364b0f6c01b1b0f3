/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyantPatches.H"

#include "thermalFluid.H"
#include "vansFields.H"
#include "zeroGradientFvPatchFields.H"

void Foam::checkBuoyantPatches
(
    const vansFields& fields,
    const thermalFluid& fluid
)
{
    if (!fluid.isBuoyant())
    {
        return;
    }
    fluid.weight().requireLevelPeriods();
    forAll(fields.p_rgh.boundaryField(), patchi)
    {
        const fvPatchScalarField& p = fields.p_rgh.boundaryField()[patchi];
        const fvPatchVectorField& U = fields.U.boundaryField()[patchi];
        if (isA<zeroGradientFvPatchScalarField>(p) && !U.assignable())
        {
            FatalErrorInFunction
                << "The patch " << p.patch().name() << " of the field "
                << fields.p_rgh.objectPath() << " has the type " << p.type()
                << ": with beta in transportProperties fluid would pass it" << nl
                << "    allowed: fixedFluxPressure, or a given pressure"
                << exit(FatalError);
        }
    }
}
