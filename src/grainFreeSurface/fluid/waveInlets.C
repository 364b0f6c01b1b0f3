/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waveInlets.H"

#include "surfaceFields.H"
#include "volFields.H"

void Foam::checkWaveInlets(const volVectorField& U, const vector& g)
{
    if (mag(g) == 0)
    {
        return;
    }
    for (const fvPatchVectorField& patch : U.boundaryField())
    {
        if (patch.type() != "waveVelocity")
        {
            continue;
        }
        const vector x(normalised(-gAverage(patch.patch().Sf())));
        const vector z(-g/mag(g));
        const tensor axes(x, z ^ x, z);
        if (mag(axes - axes.T()) > 1e-6)
        {
            FatalErrorInFunction
                << U.objectPath() << ": waves of type waveVelocity come in through"
                << " patch '" << patch.patch().name() << "' along " << x
                << ", gravity in constant/g is along " << -z << nl
                << "    OpenFOAM's wave models have other axes there" << nl
                << "    allowed: gravity along (0 0 -1), waves along (1 0 0) or"
                << " (-1 0 0)" << exit(FatalError);
        }
    }
}
